#include <algorithm>
#include <array>
#include <cstdint>

#include "core/event/picture_samples.h"
#include "core/perception/pictures/coding/picture_decoding.h"
#include "fuzz/input_file.h"

/// Pictures as robots send them. The first byte chooses the encoding, five more width, height and the bytes
/// that a row has beyond its pixels; the rest is the picture.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    constexpr std::size_t Head = 6;
    constexpr std::array<const char*, 10> Encodings = {
        "jpeg", "png", "rgb8", "bgr8", "mono8", "mono16", "yuv422_yuy2", "16UC1", "32FC1", "bayer_rggb8"};
    if (size < Head) return 0;
    PictureSample sample;
    sample.encoding = Encodings[data[0] % Encodings.size()];
    sample.compressed = data[0] % Encodings.size() < 2;
    sample.bigEndian = data[0] >= 128;
    if (!sample.compressed) {
        sample.width = data[1];
        sample.height = data[2];
        sample.step = static_cast<std::size_t>(data[3]) * 4 + data[4];
    }
    const auto content = std::make_shared<std::vector<std::byte>>(size - Head);
    std::transform(data + Head, data + size, content->begin(), [](std::uint8_t b) { return std::byte{b}; });
    sample.content = {content, *content};
    PictureLimits limits;
    limits.maxPixels = 1'000'000;
    const auto picture = decodePicture(sample, limits);
    if (!picture) {
        fuzz::require(!picture.error().text.empty(), "an error that tells something");
        return 0;
    }
    const auto pixels = static_cast<std::size_t>(picture->width) * static_cast<std::size_t>(picture->height);
    fuzz::require(pixels <= 1'000'000, "a picture within the limits");
    fuzz::require(picture->bytes.size() == pixels * picture->pixelSize(), "as many bytes as pixels need");
    const auto warm = temperatures(*picture, ThermalScale{});
    fuzz::require(!warm || warm->celsius.size() == pixels, "a temperature for each pixel");
    return 0;
}
