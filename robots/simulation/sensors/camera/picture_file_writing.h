#pragma once

#include <cstdint>
#include <vector>

#include "core/base/shared_bytes.h"

namespace leitstand::simulation {

/// Returns a JPEG file of @p bgr8 pixels, row-major. @p quality: 1 to 100. Throws std::runtime_error when the
/// library cannot write it.
[[nodiscard]] SharedBytes jpegFile(const std::vector<std::uint8_t>& bgr8, int width, int height, int quality);
/// Returns a PNG file of 16-bit @p grey pixels, row-major. Throws as jpegFile() does.
[[nodiscard]] SharedBytes pngFile(const std::vector<std::uint16_t>& grey, int width, int height);

}  // namespace leitstand::simulation
