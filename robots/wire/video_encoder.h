#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/perception/pictures/picture.h"
#include "core/perception/pictures/video/video_packet.h"

namespace leitstand {

struct VideoEncoding {
    VideoCodec codec = VideoCodec::H264;
    double rate = 10.0;     ///< pictures [Hz]
    int keyEvery = 10;      ///< pictures from one key picture to the next (ffmpeg_image_transport's gop_size)
    double megabits = 1.0;  ///< aimed at [Mbit/s]
};

/// Makes a video of pictures, as the encoders of robots do: each picture is sent at once, none needs a later
/// one. One thread at a time.
class VideoEncoder {
public:
    explicit VideoEncoder(const VideoEncoding& encoding);
    ~VideoEncoder();

    /// Returns the next picture of the video (Annex B). The first, and one of another size, is a key picture.
    /// Error: the picture is not in colour or grey with 8 bits, or has odd sizes; libavcodec has no encoder.
    [[nodiscard]] Result<std::vector<std::byte>> encode(const Picture& picture);
    /// Makes the next picture a key picture.
    void restart();

private:
    class Codec;
    VideoEncoding m_encoding;
    std::unique_ptr<Codec> m_codec;
};

}  // namespace leitstand
