#pragma once

#include "core/base/result.h"
#include "core/perception/picture.h"
#include "core/robot/robot_description.h"
#include "core/robot/samples/picture_samples.h"

namespace leitstand {

/// What is refused before anything is allocated.
struct PictureLimits {
    int maxSide = 16384;                  ///< [px]
    std::int64_t maxPixels = 50'000'000;  ///< of the whole picture
};

/// Decodes a raw or compressed (JPEG, PNG; PNG of 8 or 16 bits) picture. The size stands in the file's header
/// and is checked first. Colour becomes Rgb8, 16-bit grey Grey16.
[[nodiscard]] Result<Picture> decodePicture(const PictureSample& sample, const PictureLimits& limits = {});

/// Temperatures by the raw numbers of a Grey16, Float32 or Grey8 picture; below absolute zero is NaN. An
/// error for colours and where the scale says that the camera measures none.
[[nodiscard]] Result<ThermalPicture> temperatures(const Picture& picture, const ThermalScale& scale);

}  // namespace leitstand
