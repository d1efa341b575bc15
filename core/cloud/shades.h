#pragma once

#include <cstdint>
#include <vector>

namespace leitstand {

/// Returns one byte for each intensity, for colouring points. It depends on the logarithm, since sensors use
/// different units. If no intensity is above 1, all are first multiplied by 255. Neighbouring shades differ
/// by 4.4 %; NaN and values that are not above zero give 0.
[[nodiscard]] std::vector<std::uint8_t> shadesOf(const std::vector<float>& intensities);

}  // namespace leitstand
