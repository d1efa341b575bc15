#pragma once

#include "core/base/result.h"

namespace leitstand {

struct PictureSample;

/// Returns a compressed picture as sensor_msgs/msg/Image carries it: mono8, mono16 (temperatures) or rgb8.
/// One that is not compressed stays as it is. The error reports why the file cannot be read.
[[nodiscard]] Result<PictureSample> rawPicture(const PictureSample& picture);

}  // namespace leitstand
