#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/event/picture_samples.h"
#include "core/perception/pictures/coding/picture_decoding.h"
#include "core/perception/pictures/video/video_bitstream.h"
#include "core/perception/pictures/video/video_chains.h"
#include "core/perception/pictures/video/video_packet.h"
#include "fuzz/input_file.h"

/// A video as a robot sends it. The first byte chooses the codec; then pictures, each after two bytes with
/// its size.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    constexpr std::int64_t MostPixels = 100'000;
    constexpr int MostPictures = 12;
    if (size < 1) return 0;
    const VideoCodec codec = data[0] % 2 == 0 ? VideoCodec::H264 : VideoCodec::H265;
    PictureLimits limits;
    limits.maxVideoPixels = MostPixels;
    PictureDecoder decoder(limits);
    VideoChains chains;
    std::size_t at = 1;
    for (int i = 0; i < MostPictures && at + 2 < size; ++i) {
        const std::size_t wanted = data[at] + 256U * data[at + 1];
        at += 2;
        const std::size_t length = std::min(wanted, size - at);
        const auto content =
            std::make_shared<std::vector<std::byte>>(reinterpret_cast<const std::byte*>(data) + at,
                                                     reinterpret_cast<const std::byte*>(data) + at + length);
        at += length;
        PictureSample sample;
        sample.compressed = true;
        sample.content = {content, *content};
        sample.video = std::make_shared<const VideoPacket>(
            VideoPacket{.codec = codec, .key = isKeyPicture(codec, *content), .bytes = sample.content});
        chains.link("/camera", sample);
        const auto picture = decoder.decode(sample);
        if (!picture) {
            fuzz::require(!picture.error().text.empty(), "an error that tells something");
            continue;
        }
        const auto pixels =
            static_cast<std::size_t>(picture->width) * static_cast<std::size_t>(picture->height);
        fuzz::require(pixels <= static_cast<std::size_t>(MostPixels), "a picture within the limits");
        fuzz::require(picture->bytes.size() == pixels * picture->pixelSize(), "as many bytes as pixels need");
    }
    return 0;
}
