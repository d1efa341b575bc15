#pragma once

#include <cstdint>
#include <vector>

namespace leitstand {

/// Intensities in a byte each, to colour points by: their logarithm, since sensors give them in units of
/// their own. Those that are shares (none above 1) count as such of 255. Neighbouring shades are 4.4 % apart;
/// NaN and what is not above zero is 0.
[[nodiscard]] std::vector<std::uint8_t> shadesOf(const std::vector<float>& intensities);

}  // namespace leitstand
