#pragma once

#include <cstdint>
#include <vector>

#include "core/base/shared_bytes.h"

namespace leitstand::simulation {

/// Returns a JPEG file of the pixels @p bgr8, row by row. @p quality: 1 to 100. Throws std::runtime_error
/// when the library cannot write it.
[[nodiscard]] SharedBytes jpegFile(const std::vector<std::uint8_t>& bgr8, int width, int height, int quality);
/// Returns a PNG file of the 16-bit pixels @p grey, row by row. Throws as jpegFile() does.
[[nodiscard]] SharedBytes pngFile(const std::vector<std::uint16_t>& grey, int width, int height);

}  // namespace leitstand::simulation
