#pragma once

#include <limits>

namespace leitstand {

/// Stands for a number that the sender does not know; NaN.
inline constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace leitstand
