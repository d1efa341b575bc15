#pragma once

#include <QString>

namespace leitstand {

/// @p value with @p digits after the point, as the report's language writes it; a dash where it is not known.
[[nodiscard]] QString reportNumber(double value, int digits);

}  // namespace leitstand
