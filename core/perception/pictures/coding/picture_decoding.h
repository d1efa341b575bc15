#pragma once

#include <cstdint>
#include <stop_token>

#include "core/base/result.h"
#include "core/perception/pictures/picture.h"
#include "core/perception/pictures/video/video_decoder.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct PictureSample;

/// Limits that are checked before memory is allocated. Those for files allow 16 megapixels in colour, which
/// are decoded in less than a second.
struct PictureLimits {
    int maxSide = 16384;                      ///< largest width and height [px]
    std::int64_t maxPixels = 50'000'000;      ///< largest number of pixels of any picture
    std::int64_t maxFilePixels = 16'777'216;  ///< largest number of pixels of a picture that is a file
    /// Largest number of pixels of a picture of a video (4096 x 2304); a decoder holds up to 16 of them.
    std::int64_t maxVideoPixels = 9'437'184;
    std::int64_t maxFileBytes = 64 << 20;  ///< largest size of a file's decoded pixels [B]
    /// Largest number of scans of a JPEG; usually there is 1, or about 10 if it is progressive.
    std::int64_t maxScans = 100;
    std::int64_t maxScanPixels = 128'000'000;  ///< largest product of a JPEG's pixels and scans
};

/// Decodes a raw or compressed picture (JPEG, or PNG of 8 or 16 bits), or one of a video with all that it
/// needs. First checks what a file would cost (picture_cost.h). Colours become Rgb8, 16-bit grey becomes
/// Grey16.
[[nodiscard]] Result<Picture> decodePicture(const PictureSample& sample, const PictureLimits& limits = {});

/// Decodes the pictures of one camera as decodePicture() does. Of a video, pictures that follow each other
/// are decoded once. One thread at a time.
class PictureDecoder {
public:
    PictureDecoder() : PictureDecoder(PictureLimits{}) {}
    explicit PictureDecoder(const PictureLimits& limits) : m_limits(limits), m_video(limits.maxVideoPixels) {}
    /// @p stop: ends the decoding of a video early, with an error.
    [[nodiscard]] Result<Picture> decode(const PictureSample& sample, const std::stop_token& stop = {});

private:
    PictureLimits m_limits;
    VideoDecoder m_video;
};

/// Converts the raw values of a Grey16, Float32 or Grey8 picture to temperatures; NaN below absolute zero.
/// Error for colours, and when @p scale says that the camera measures no temperatures.
[[nodiscard]] Result<ThermalPicture> temperatures(const Picture& picture, const ThermalScale& scale);

}  // namespace leitstand
