#pragma once

#include <QString>

namespace leitstand {

/// Returns @p value with @p digits decimals in the report's language; a dash if it is not finite.
[[nodiscard]] QString reportNumber(double value, int digits);

}  // namespace leitstand
