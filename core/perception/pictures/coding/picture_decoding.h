#pragma once

#include "core/base/result.h"
#include "core/perception/pictures/picture.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct PictureSample;

/// Limits that are checked before anything is allocated. Those for files allow 16 megapixels in colour, which
/// are decoded in less than a second.
struct PictureLimits {
    int maxSide = 16384;                       ///< [px]
    std::int64_t maxPixels = 50'000'000;       ///< of the whole picture
    std::int64_t maxFilePixels = 16'777'216;   ///< of a picture that comes as a file
    std::int64_t maxFileBytes = 64 << 20;      ///< of the decoded pixels of a file [B]
    std::int64_t maxScans = 100;               ///< of a JPEG; usual is 1, about 10 if it is progressive
    std::int64_t maxScanPixels = 128'000'000;  ///< pixels of a JPEG times its number of scans
};

/// Decodes a raw or compressed (JPEG, or PNG of 8 or 16 bits) picture. The cost of a file is checked first
/// (picture_cost.h). Colour becomes Rgb8, 16-bit grey Grey16.
[[nodiscard]] Result<Picture> decodePicture(const PictureSample& sample, const PictureLimits& limits = {});

/// Converts the raw numbers of a Grey16, Float32 or Grey8 picture to temperatures; NaN below absolute zero.
/// Error for colours, and when @p scale says that the camera measures no temperatures.
[[nodiscard]] Result<ThermalPicture> temperatures(const Picture& picture, const ThermalScale& scale);

}  // namespace leitstand
