#pragma once

#include <cstddef>
#include <string_view>

#include "core/base/result.h"

namespace leitstand {

struct PictureSample;

/// A depth picture that compressed_depth_image_transport sends: 12 bytes (a format and two parameters), then
/// its data. These are a PNG of 16 bits, or RVL (Wilson 2017) after the numbers of columns and rows.
namespace depth_file {

constexpr std::size_t Head = 12;    ///< format, A, B: 4 bytes each [B]
constexpr std::size_t RvlHead = 8;  ///< columns, rows [B]

/// Whether @p encoding is the format of such a picture: "16UC1; compressedDepth png".
[[nodiscard]] bool isDepth(std::string_view encoding);
[[nodiscard]] bool isRvl(std::string_view encoding);
/// Returns what is wrong with @p sample as far as its head shows; no error: it may be decoded.
[[nodiscard]] Result<void> check(const PictureSample& sample);

}  // namespace depth_file

}  // namespace leitstand
