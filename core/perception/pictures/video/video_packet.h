#pragma once

#include <cstdint>
#include <memory>

#include "core/base/shared_bytes.h"

namespace leitstand {

enum class VideoCodec : std::uint8_t { H264, H265 };

/// One picture of a video as it was sent. Unless it is a key picture, it is decoded from the pictures before
/// it, back to the last key picture.
struct VideoPacket {
    VideoCodec codec = VideoCodec::H264;
    bool key = false;   ///< whether decoding can start here
    SharedBytes bytes;  ///< NAL units with start codes (Annex B of H.264 and H.265)
    /// Of a key picture whose parameters (SPS, PPS, VPS) were sent before it: these; else nothing.
    SharedBytes parameters{};
    /// Null: a key picture, or the pictures that it needs are not there.
    std::shared_ptr<const VideoPacket> before{};
    int sinceKey = 0;  ///< number of pictures that have to be decoded before it
    int waited = 0;    ///< number of pictures since the last one that could be decoded

    [[nodiscard]] bool decodable() const { return key || before != nullptr; }
};

}  // namespace leitstand
