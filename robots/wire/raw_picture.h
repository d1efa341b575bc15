#pragma once

#include "core/base/result.h"

namespace leitstand {

struct PictureSample;

/// Returns a compressed picture as sensor_msgs/msg/Image carries it: mono8, mono16 (temperatures) or rgb8. A
/// picture that is not compressed is returned unchanged. The error says why the compressed file cannot be
/// read.
[[nodiscard]] Result<PictureSample> rawPicture(const PictureSample& picture);

}  // namespace leitstand
