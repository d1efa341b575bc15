#pragma once

#include "core/base/result.h"

namespace leitstand {

struct PictureSample;

/// Decompresses a picture to one that sensor_msgs/msg/Image can hold: mono8, mono16 (temperatures) or rgb8. A
/// picture that is not compressed is returned as it is. The error says why the compressed file cannot be
/// read.
[[nodiscard]] Result<PictureSample> rawPicture(const PictureSample& picture);

}  // namespace leitstand
