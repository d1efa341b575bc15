#pragma once

#include "core/base/result.h"
#include "core/event/picture_samples.h"
#include "core/perception/pictures/picture.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// What is refused before anything is allocated. The bounds of files are those of 16 megapixels in colour,
/// which take less than a second.
struct PictureLimits {
    int maxSide = 16384;                       ///< [px]
    std::int64_t maxPixels = 50'000'000;       ///< of the whole picture
    std::int64_t maxFilePixels = 16'777'216;   ///< of one that comes as a file
    std::int64_t maxFileBytes = 64 << 20;      ///< of its pixels when it is decoded [B]
    std::int64_t maxScans = 100;               ///< of a JPEG; usual are 1, progressive about 10
    std::int64_t maxScanPixels = 128'000'000;  ///< pixels of a JPEG times its scans
};

/// Decodes a raw or compressed (JPEG, PNG; PNG of 8 or 16 bits) picture. What it will cost stands in the file
/// and is checked first (picture_cost.h). Colour becomes Rgb8, 16-bit grey Grey16.
[[nodiscard]] Result<Picture> decodePicture(const PictureSample& sample, const PictureLimits& limits = {});

/// Temperatures by the raw numbers of a Grey16, Float32 or Grey8 picture; below absolute zero is NaN. An
/// error for colours and where the scale says that the camera measures none.
[[nodiscard]] Result<ThermalPicture> temperatures(const Picture& picture, const ThermalScale& scale);

}  // namespace leitstand
