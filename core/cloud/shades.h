#pragma once

#include <cstdint>
#include <vector>

namespace leitstand {

/// Returns intensities as a byte each, to colour points by: their logarithm, since sensors use units of their
/// own. Shares (none above 1) are first multiplied by 255. Neighbouring shades are 4.4 % apart; NaN and
/// values that are not above zero give 0.
[[nodiscard]] std::vector<std::uint8_t> shadesOf(const std::vector<float>& intensities);

}  // namespace leitstand
