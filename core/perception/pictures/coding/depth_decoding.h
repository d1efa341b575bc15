#pragma once

#include "core/base/result.h"
#include "core/perception/pictures/picture.h"

namespace leitstand {

struct PictureLimits;
struct PictureSample;

/// Decodes a depth picture of compressed_depth_image_transport (depth_file::isDepth()): Grey16 as it is in
/// millimetres, Float32 as metres, NaN where there is no depth. "32FC1" holds inverse depths: depth = A /
/// (value - B).
[[nodiscard]] Result<Picture> decodeDepthFile(const PictureSample& sample, const PictureLimits& limits);

}  // namespace leitstand
