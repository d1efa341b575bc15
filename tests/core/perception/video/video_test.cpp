// Videos of robots' cameras: each picture can be shown, what is missing is never shown wrongly.
#include <algorithm>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "core/perception/pictures/coding/picture_decoding.h"
#include "core/perception/pictures/video/video_bitstream.h"
#include "core/perception/pictures/video/video_chains.h"
#include "tests/core/perception/video/filmed.h"
#include "tests/support/samples.h"

namespace leitstand::test {
namespace {

constexpr double Alike = 6.0;  ///< mean difference of a picture that was encoded

std::vector<PictureSample> linked(std::vector<PictureSample> film) {
    VideoChains chains;
    for (PictureSample& sample : film) chains.link("/camera", sample);
    return film;
}

std::vector<std::size_t> keysOf(const std::vector<PictureSample>& film) {
    std::vector<std::size_t> keys;
    for (std::size_t i = 0; i < film.size(); ++i)
        if (film[i].video->key) keys.push_back(i);
    return keys;
}

void damage(PictureSample& sample) {
    std::vector<std::byte> bytes(sample.content.bytes.begin(), sample.content.bytes.end());
    for (std::size_t i = bytes.size() / 3; i < bytes.size(); ++i) bytes[i] ^= std::byte{0x5a};
    sample.content = sharedBytes(std::move(bytes));
    VideoPacket packet = *sample.video;
    packet.bytes = sample.content;
    sample.video = std::make_shared<const VideoPacket>(packet);
}

class Videos : public testing::TestWithParam<VideoCodec> {};
INSTANTIATE_TEST_SUITE_P(, Videos, testing::Values(VideoCodec::H264, VideoCodec::H265),
                         [](const auto& given) { return given.param == VideoCodec::H264 ? "H264" : "H265"; });

TEST_P(Videos, KeyPicturesAreToldFromTheOthers) {
    EXPECT_EQ(keysOf(filmed(25, 10, GetParam())), (std::vector<std::size_t>{0, 10, 20}));
}

TEST_P(Videos, EachPictureIsDecodedByItselfAsOneAfterTheOther) {
    const auto film = linked(filmed(24, 10, GetParam()));
    PictureDecoder follows;
    for (std::size_t i = 0; i < film.size(); ++i) {
        const auto alone = decodePicture(film[i]);
        const auto after = follows.decode(film[i]);
        ASSERT_TRUE(alone.ok()) << i << ": " << alone.error().text;
        ASSERT_TRUE(after.ok()) << i << ": " << after.error().text;
        EXPECT_EQ(alone->bytes, after->bytes) << i;
        EXPECT_LT(difference(*alone, movingScene(static_cast<int>(i))), Alike) << i;
    }
}

TEST_P(Videos, TheyAreSeenBackwardsAndWithGapsAsForwards) {
    const auto film = linked(filmed(24, 10, GetParam()));
    PictureDecoder decoder;
    for (const std::size_t i : {23U, 22U, 21U, 9U, 8U, 15U, 15U, 3U, 19U}) {
        const auto picture = decoder.decode(film[i]);
        ASSERT_TRUE(picture.ok()) << i << ": " << picture.error().text;
        EXPECT_LT(difference(*picture, movingScene(static_cast<int>(i))), Alike) << i;
    }
}

TEST_P(Videos, WhoComesInTheMiddleSeesTheNextKeyPictureFirst) {
    auto film = filmed(24, 10, GetParam());
    film.erase(film.begin(), film.begin() + 4);
    film = linked(std::move(film));
    PictureDecoder decoder;
    for (std::size_t i = 0; i < film.size(); ++i) {
        const auto picture = decoder.decode(film[i]);
        EXPECT_EQ(picture.ok(), i >= 6) << i;
        if (!picture) {
            EXPECT_NE(picture.error().text.find("key picture"), std::string::npos) << picture.error().text;
            EXPECT_EQ(film[i].video->waited, static_cast<int>(i) + 1);
        }
    }
}

TEST_P(Videos, TheNextKeyPictureHealsADamagedOne) {
    auto film = filmed(24, 10, GetParam());
    damage(film[4]);
    film = linked(std::move(film));
    PictureDecoder decoder;
    for (std::size_t i = 0; i < film.size(); ++i) {
        const auto picture = decoder.decode(film[i]);
        if (i == 4 && GetParam() == VideoCodec::H264) {
            EXPECT_FALSE(picture.ok()) << "H.265 is decoded to something else, unnoticed";
        } else if (GetParam() == VideoCodec::H264 && i > 4 && i < 10) {
            EXPECT_FALSE(picture.ok()) << i << ": what follows a damaged picture is wrong";
        } else if (i < 4 || i >= 10) {
            ASSERT_TRUE(picture.ok()) << i << ": " << picture.error().text;
            EXPECT_LT(difference(*picture, movingScene(static_cast<int>(i))), Alike) << i;
        }
    }
}

TEST_P(Videos, PicturesOfAnyWidthAreWhole) {
    for (const int width : {250, 300, 854, 1366}) {
        const auto film = linked(filmed(1, 10, GetParam(), width, 96));
        const auto picture = decodePicture(film.front());
        ASSERT_TRUE(picture) << width << ": " << picture.error().text;
        Picture edge{16, 96, Picture::Pixel::Rgb8, {}}, wanted = edge;
        const Picture scene = movingScene(0, width, 96);
        for (int y = 0; y < 96; ++y) {
            const auto last = std::ptrdiff_t{3} * (y + 1) * width;
            edge.bytes.insert(edge.bytes.end(), picture->bytes.begin() + last - 48,
                              picture->bytes.begin() + last);
            wanted.bytes.insert(wanted.bytes.end(), scene.bytes.begin() + last - 48,
                                scene.bytes.begin() + last);
        }
        EXPECT_LT(difference(edge, wanted), 8.0) << width;
    }
}

TEST_P(Videos, ParametersThatAreSentByThemselvesGoWithTheNextKeyPicture) {
    auto film = filmed(14, 10, GetParam());
    // The first message in two: parameters, then the picture. The second key picture comes without
    // parameters.
    const auto withoutParameters = [&](const PictureSample& sample, bool parameters) {
        const auto bytes = sample.content.bytes;
        std::size_t picture = 0;  // where the unit of the picture begins
        for (std::size_t at = 0; at + 4 < bytes.size() && picture == 0; ++at) {
            if (!hasStartCode(bytes.subspan(at))) continue;
            if (contentsOf(GetParam(), bytes.subspan(at, std::min<std::size_t>(6, bytes.size() - at)))
                    .picture)
                picture = at;
        }
        PictureSample part = sample;
        const auto chosen = parameters ? bytes.first(picture) : bytes.subspan(picture);
        part.content = sharedBytes({chosen.begin(), chosen.end()});
        part.video = std::make_shared<const VideoPacket>(VideoPacket{
            .codec = GetParam(), .key = isKeyPicture(GetParam(), part.content.bytes), .bytes = part.content});
        return part;
    };
    const PictureSample parameters = withoutParameters(film[0], true);
    ASSERT_FALSE(contentsOf(GetParam(), parameters.content.bytes).picture);
    film[0] = withoutParameters(film[0], false);
    film[10] = withoutParameters(film[10], false);
    film.insert(film.begin(), parameters);
    film = linked(std::move(film));
    PictureDecoder decoder;
    EXPECT_FALSE(decoder.decode(film.front()).ok());
    for (std::size_t i = 1; i < film.size(); ++i) {
        const auto picture = decoder.decode(film[i]);
        ASSERT_TRUE(picture) << i << ": " << picture.error().text;
        EXPECT_LT(difference(*picture, movingScene(static_cast<int>(i) - 1)), Alike) << i;
    }
}

TEST_P(Videos, WhatIsTooLargeIsRefused) {
    const auto film = linked(filmed(1, 10, GetParam()));
    PictureLimits limits;
    limits.maxVideoPixels = std::int64_t{160} * 120 - 1;
    EXPECT_FALSE(decodePicture(film.front(), limits).ok());
    limits.maxVideoPixels = std::int64_t{160} * 120;
    EXPECT_TRUE(decodePicture(film.front(), limits).ok());
}

TEST_P(Videos, RandomBytesAfterAStartCodeHurtNothing) {
    std::mt19937 random(7);
    std::vector<PictureSample> film = filmed(3, 10, GetParam());
    for (int i = 0; i < 300; ++i) {
        std::vector<std::byte> bytes = {std::byte{0}, std::byte{0}, std::byte{1}};
        const std::size_t size = random() % 400;
        for (std::size_t k = 0; k < size; ++k) bytes.push_back(static_cast<std::byte>(random()));
        PictureSample sample = film.front();
        sample.content = sharedBytes(std::move(bytes));
        sample.video = std::make_shared<const VideoPacket>(
            VideoPacket{.codec = GetParam(),
                        .key = isKeyPicture(GetParam(), sample.content.bytes),
                        .bytes = sample.content});
        film.push_back(std::move(sample));
    }
    film = linked(std::move(film));
    PictureDecoder decoder;
    for (const PictureSample& sample : film) (void)decoder.decode(sample);
    const auto after = filmed(1, 10, GetParam());
    EXPECT_TRUE(decoder.decode(after.front()).ok()) << "a key picture heals it";
}

TEST(VideoChains, WhereAPictureIsMissingNothingIsShownUntilTheNextKeyPicture) {
    auto film = filmed(24, 10);
    film.erase(film.begin() + 4);
    film = linked(std::move(film));
    for (std::size_t i = 0; i < film.size(); ++i) EXPECT_EQ(film[i].video->decodable(), i < 4 || i >= 9) << i;
}

TEST(VideoChains, NumbersThatBeginAgainAreNoGap) {
    const auto film = linked(filmed(80, 1000));  // frame_num has 4 bits, or a few more
    EXPECT_EQ(keysOf(film).size(), 1U);
    for (std::size_t i = 0; i < film.size(); ++i) EXPECT_TRUE(film[i].video->decodable()) << i;
    EXPECT_EQ(film.back().video->sinceKey, 79);
}

TEST(VideoChains, WhatHasNoKeyPictureForTooLongIsGivenUp) {
    const auto film = linked(filmed(VideoChains::MostPictures + 3, 10'000, VideoCodec::H264, 32, 32));
    EXPECT_TRUE(film[VideoChains::MostPictures - 1].video->decodable());
    EXPECT_FALSE(film[VideoChains::MostPictures].video->decodable());
    EXPECT_FALSE(film.back().video->decodable());
    const auto picture = decodePicture(film.back());
    ASSERT_FALSE(picture.ok());
    EXPECT_NE(picture.error().text.find("gop_size"), std::string::npos) << picture.error().text;
}

TEST(VideoChains, ATopicThatWasLeftDoesNotGoOn) {
    auto film = filmed(12, 10);
    VideoChains chains;
    for (int i = 0; i < 3; ++i) chains.link("/camera", film[static_cast<std::size_t>(i)]);
    EXPECT_TRUE(chains.isDecodable("/camera"));
    chains.forget("/camera");
    chains.link("/camera", film[3]);
    EXPECT_FALSE(chains.isDecodable("/camera"));
    chains.link("/camera", film[10]);
    EXPECT_TRUE(chains.isDecodable("/camera"));
    EXPECT_FALSE(chains.isDecodable("/other"));
}

TEST(VideoBitstream, TheCodecIsFoundInTheNamesOfEncoders) {
    for (const char* name : {"h264", "libx264", "h264_nvenc", "video/h264"})
        EXPECT_EQ(videoCodecOf(name), VideoCodec::H264) << name;
    for (const char* name : {"h265", "hevc", "hevc_vaapi", "libx265"})
        EXPECT_EQ(videoCodecOf(name), VideoCodec::H265) << name;
    for (const char* name : {"", "vp9", "av1", "mjpeg", "jpeg"}) EXPECT_FALSE(videoCodecOf(name)) << name;
}

TEST(VideoBitstream, StartCodesHaveTwoOrThreeZeros) {
    const auto begins = [](std::initializer_list<int> values) {
        std::vector<std::byte> bytes;
        for (const int value : values) bytes.push_back(static_cast<std::byte>(value));
        return hasStartCode(bytes);
    };
    EXPECT_TRUE(begins({0, 0, 1, 9}));
    EXPECT_TRUE(begins({0, 0, 0, 1, 9}));
    EXPECT_FALSE(begins({0, 1, 9}));
    EXPECT_FALSE(begins({0xff, 0xd8, 0xff}));
    EXPECT_FALSE(begins({0, 0, 0, 0}));
    EXPECT_FALSE(begins({}));
}

}  // namespace
}  // namespace leitstand::test
