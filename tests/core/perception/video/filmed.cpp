#include "tests/core/perception/video/filmed.h"

#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "core/perception/pictures/video/video_bitstream.h"
#include "robots/wire/video_encoder.h"
#include "tests/support/samples.h"

namespace leitstand::test {

Picture movingScene(int number, int width, int height) {
    Picture picture{width, height, Picture::Pixel::Rgb8, {}};
    picture.bytes.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double wave = std::sin(0.08 * (x + 3 * number)) + std::cos(0.06 * (y - 2 * number));
            for (int channel = 0; channel < 3; ++channel)
                picture.bytes.push_back(
                    static_cast<std::byte>(120 + 20 * channel + static_cast<int>(45 * wave)));
        }
    }
    return picture;
}

std::vector<PictureSample> filmed(int count, int keyEvery, VideoCodec codec, int width, int height) {
    VideoEncoding encoding;
    encoding.codec = codec;
    encoding.keyEvery = keyEvery;
    VideoEncoder encoder(encoding);
    std::vector<PictureSample> film;
    for (int i = 0; i < count; ++i) {
        auto bytes = encoder.encode(movingScene(i, width, height));
        if (!bytes) throw std::runtime_error(bytes.error().text);
        PictureSample sample;
        sample.header.stamp = Time(std::chrono::milliseconds(100 * (i + 1)));
        sample.header.frame = "camera";
        sample.compressed = true;
        sample.encoding = codec == VideoCodec::H264 ? "h264" : "hevc";
        sample.width = width;
        sample.height = height;
        sample.content = sharedBytes(std::move(bytes).value());
        sample.video = std::make_shared<const VideoPacket>(VideoPacket{
            .codec = codec, .key = isKeyPicture(codec, sample.content.bytes), .bytes = sample.content});
        film.push_back(std::move(sample));
    }
    return film;
}

double difference(const Picture& a, const Picture& b) {
    if (a.bytes.size() != b.bytes.size()) return 255.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < a.bytes.size(); ++i)
        sum += std::abs(std::to_integer<int>(a.bytes[i]) - std::to_integer<int>(b.bytes[i]));
    return sum / static_cast<double>(a.bytes.size());
}

}  // namespace leitstand::test
