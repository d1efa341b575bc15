#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/perception/pictures.h"

namespace leitstand::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Pixel = Picture::Pixel;

TEST(RawPictures, ColoursComeOutAsRedGreenBlue) {
    const auto rgb = [](const std::string& encoding, std::initializer_list<int> pixel) {
        const auto picture = decodePicture(rawPicture(encoding, 1, 1, pixel.size(), bytesOf(pixel)));
        EXPECT_TRUE(picture) << picture.error().text;
        EXPECT_EQ(picture->pixel, Pixel::Rgb8);
        return valuesOf(*picture);
    };
    EXPECT_THAT(rgb("rgb8", {1, 2, 3}), ElementsAre(1, 2, 3));
    EXPECT_THAT(rgb("bgr8", {3, 2, 1}), ElementsAre(1, 2, 3));
    EXPECT_THAT(rgb("8UC3", {3, 2, 1}), ElementsAre(1, 2, 3));
    EXPECT_THAT(rgb("rgba8", {1, 2, 3, 9}), ElementsAre(1, 2, 3));
    EXPECT_THAT(rgb("bgra8", {3, 2, 1, 9}), ElementsAre(1, 2, 3));
}

// Y 145, U 54, V 34 is pure green of ITU-R BT.601 in video range.
TEST(RawPictures, YuvInBothOrders) {
    const auto expectGreen = [](const char* encoding, std::initializer_list<int> pixels) {
        const auto picture = decodePicture(rawPicture(encoding, 2, 1, 4, bytesOf(pixels)));
        ASSERT_TRUE(picture) << picture.error().text;
        const auto values = valuesOf(*picture);
        EXPECT_NEAR(values[0], 0, 3) << encoding;
        EXPECT_NEAR(values[1], 255, 3) << encoding;
        EXPECT_NEAR(values[2], 0, 3) << encoding;
    };
    for (const char* encoding : {"yuyv", "yuv422_yuy2"}) expectGreen(encoding, {145, 54, 145, 34});
    for (const char* encoding : {"uyvy", "yuv422"}) expectGreen(encoding, {54, 145, 34, 145});
}

// A red scene: only the red cells of the pattern see anything, and all of the picture becomes red.
TEST(RawPictures, BayerPatternsBeginWhereTheirNamesSay) {
    const std::pair<const char*, std::pair<int, int>> patterns[] = {
        {"bayer_rggb8", {0, 0}}, {"bayer_bggr8", {1, 1}}, {"bayer_grbg8", {1, 0}}, {"bayer_gbrg8", {0, 1}}};
    for (const auto& [encoding, red] : patterns) {
        std::vector<std::byte> bytes(64);
        for (int y = red.second; y < 8; y += 2) {
            for (int x = red.first; x < 8; x += 2)
                bytes[static_cast<std::size_t>(8 * y + x)] = std::byte{200};
        }
        const auto picture = decodePicture(rawPicture(encoding, 8, 8, 8, bytes));
        ASSERT_TRUE(picture) << picture.error().text;
        const auto values = valuesOf(*picture);
        const std::size_t centre = 3 * (8 * 4 + 4);
        EXPECT_EQ(values[centre], 200) << encoding;
        EXPECT_EQ(values[centre + 1], 0) << encoding;
        EXPECT_EQ(values[centre + 2], 0) << encoding;
    }
}

TEST(RawPictures, GreyOfEveryDepthAndByteOrderWithPaddedRows) {
    const auto bytes = bytesOf({1, 2, 99, 3, 4, 99});
    for (const char* encoding : {"mono8", "8UC1"}) {
        const auto picture = decodePicture(rawPicture(encoding, 2, 2, 3, bytes));
        ASSERT_TRUE(picture);
        EXPECT_EQ(picture->pixel, Pixel::Grey8);
        EXPECT_THAT(valuesOf(*picture), ElementsAre(1, 2, 3, 4));
    }
    for (const char* encoding : {"mono16", "16UC1"}) {
        auto sample = rawPicture(encoding, 1, 2, 2, bytesOf({0x34, 0x12, 0x78, 0x56}));
        EXPECT_THAT(valuesOf<std::uint16_t>(*decodePicture(sample)), ElementsAre(0x1234, 0x5678));
        sample.bigEndian = true;
        EXPECT_THAT(valuesOf<std::uint16_t>(*decodePicture(sample)), ElementsAre(0x3412, 0x7856));
    }
    auto depth = rawPicture("32FC1", 1, 1, 4, bytesOf({0x3f, 0xc0, 0, 0}));
    depth.bigEndian = true;
    const auto picture = decodePicture(depth);
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->pixel, Pixel::Float32);
    EXPECT_THAT(valuesOf<float>(*picture), ElementsAre(1.5F));
}

TEST(RawPictures, WhatDoesNotFitIsRefused) {
    const std::vector<std::byte> bytes(12);
    const auto error = [&](const char* encoding, int width, int height, std::size_t step) {
        return pictureError(rawPicture(encoding, width, height, step, bytes));
    };
    EXPECT_EQ(error("rgb8", 2, 2, 6), "none");
    EXPECT_THAT(error("rgb8", 2, 3, 6), HasSubstr("rows"));
    EXPECT_THAT(error("rgb8", 2, 2, 5), HasSubstr("rows"));
    EXPECT_THAT(error("rgb8", 0, 2, 6), HasSubstr("0 x 2"));
    EXPECT_THAT(error("rgb8", -1, 2, 6), HasSubstr("-1 x 2"));
    EXPECT_THAT(error("rgb8", 2, 2, std::numeric_limits<std::size_t>::max()), HasSubstr("rows"));
    EXPECT_THAT(error("h264", 2, 2, 6), HasSubstr("\"h264\""));
    EXPECT_THAT(error("bayer_rggb8", 2, 2, 2), HasSubstr("3 x 3"));
    EXPECT_THAT(error("yuyv", 3, 1, 6), HasSubstr("pairs"));
}

}  // namespace
}  // namespace leitstand::test
