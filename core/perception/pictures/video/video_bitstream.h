#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/perception/pictures/video/video_packet.h"

namespace leitstand {

/// Returns the codec that @p name means: that of a codec or of one of libav's encoders, "h264", "libx264",
/// "hevc_nvenc". Empty: another one.
[[nodiscard]] std::optional<VideoCodec> videoCodecOf(std::string_view name);

/// Whether @p bytes begin with a start code of Annex B (ITU-T H.264 B.1.1): 0 0 1, or 0 0 0 1.
[[nodiscard]] bool hasStartCode(std::span<const std::byte> bytes);

/// Whether decoding can start with the picture in @p bytes. That is an IDR picture of H.264 (NAL unit 5), or
/// a random access point of H.265 (NAL units 16 to 21); table 7-1 of both.
[[nodiscard]] bool isKeyPicture(VideoCodec codec, std::span<const std::byte> bytes);

/// What the NAL units of a message hold.
struct VideoContents {
    bool picture = false;     ///< a picture, or a part of one
    bool parameters = false;  ///< parameters of the video (SPS)
};
[[nodiscard]] VideoContents contentsOf(VideoCodec codec, std::span<const std::byte> bytes);

/// Follows the numbers of reference pictures in a video (frame_num, ITU-T H.264 7.4.3), by which a picture
/// that is missing shows. H.265 numbers its pictures otherwise; there, nothing is ever missing.
class PictureNumbers {
public:
    /// Whether all that the next picture of the video, @p bytes, needs was there: false where reference
    /// pictures are missing between the one before and this one. What cannot be read counts as complete.
    [[nodiscard]] bool follows(VideoCodec codec, std::span<const std::byte> bytes);

private:
    struct Parameters {
        int numberBits = 4;           ///< of frame_num (log2_max_frame_num)
        bool separatePlanes = false;  ///< a colour plane's number stands before frame_num
        bool gapsAllowed = false;     ///< pictures may be left out on purpose (temporal layers)
    };
    [[nodiscard]] static std::optional<Parameters> parametersIn(std::span<const std::byte> unit);

    std::optional<Parameters> m_parameters;
    std::optional<std::uint32_t> m_reference;  ///< number of the last reference picture
};

}  // namespace leitstand
