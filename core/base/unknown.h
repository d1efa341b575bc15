#pragma once

#include <limits>

namespace leitstand {

/// Value of numbers that a sender does not know.
inline constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace leitstand
