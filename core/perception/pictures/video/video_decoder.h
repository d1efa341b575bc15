#pragma once

#include <cstdint>
#include <memory>
#include <stop_token>

#include "core/base/result.h"
#include "core/perception/pictures/picture.h"

namespace leitstand {

struct VideoPacket;

/// Decodes pictures of one video, by libavcodec. Goes on from the picture before where it can, so that
/// pictures that follow each other are decoded once; otherwise it starts at the key picture. One thread at a
/// time.
class VideoDecoder {
public:
    /// @p maxPixels: pictures with more are refused; with far more before memory is taken for them.
    explicit VideoDecoder(std::int64_t maxPixels);
    ~VideoDecoder();
    VideoDecoder(VideoDecoder&&) noexcept;
    VideoDecoder& operator=(VideoDecoder&&) noexcept;

    /// Returns the picture of @p packet, in colour. Error when pictures that it needs are missing or one of
    /// them is damaged; then those that follow are in error, too, up to the next key picture.
    /// @p stop: ends it early, with an error.
    [[nodiscard]] Result<Picture> decode(const std::shared_ptr<const VideoPacket>& packet,
                                         const std::stop_token& stop = {});

private:
    class Codec;
    std::int64_t m_maxPixels;
    std::unique_ptr<Codec> m_codec;
    std::shared_ptr<const VideoPacket> m_last;  ///< the packet that was decoded last
    Result<void> m_outcome;                     ///< what came of it
};

}  // namespace leitstand
