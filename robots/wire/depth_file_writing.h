#pragma once

#include "core/base/result.h"

namespace leitstand {

struct PictureSample;

/// Returns a raw depth picture of 16 bits as compressed_depth_image_transport sends it: a PNG after 12 bytes.
[[nodiscard]] Result<PictureSample> compressedDepth(const PictureSample& raw);

}  // namespace leitstand
