#pragma once

#include <cstdint>
#include <vector>

namespace leitstand {

/// Returns one byte for each intensity, to colour points by: its logarithm, since sensors use units of their
/// own. Where no intensity is above 1, all are first multiplied by 255. Neighbouring shades are 4.4 % apart;
/// NaN and values that are not above zero give 0.
[[nodiscard]] std::vector<std::uint8_t> shadesOf(const std::vector<float>& intensities);

}  // namespace leitstand
