#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/picture_samples.h"
#include "core/perception/pictures/coding/picture_file.h"
#include "tests/core/perception/pictures.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;
using Pixel = Picture::Pixel;

TEST(PictureFiles, JpegAndPngOfEveryKindAreDecoded) {
    const cv::Mat colour(8, 16, CV_8UC3, cv::Scalar(10, 20, 200));  // blue, green, red
    const auto png = decodePicture(pictureFileOf(colour, ".png"));
    ASSERT_TRUE(png) << png.error().text;
    EXPECT_EQ(png->width, 16);
    EXPECT_EQ(png->height, 8);
    EXPECT_EQ(valuesOf(*png)[0], 200);
    EXPECT_EQ(valuesOf(*png)[1], 20);
    EXPECT_EQ(valuesOf(*png)[2], 10);
    for (const int progressive : {0, 1}) {
        const auto jpeg =
            decodePicture(pictureFileOf(colour, ".jpg", {cv::IMWRITE_JPEG_PROGRESSIVE, progressive}));
        ASSERT_TRUE(jpeg) << jpeg.error().text;
        EXPECT_NEAR(valuesOf(*jpeg)[0], 200, 4);
    }
    const auto grey = decodePicture(pictureFileOf(cv::Mat(3, 5, CV_8UC1, cv::Scalar(77)), ".png"));
    EXPECT_EQ(grey->pixel, Pixel::Grey8);
    EXPECT_EQ(valuesOf(*grey).front(), 77);
    const auto alpha = decodePicture(pictureFileOf(cv::Mat(3, 5, CV_8UC4, cv::Scalar(1, 2, 3, 4)), ".png"));
    EXPECT_EQ(alpha->pixel, Pixel::Rgb8);
    const auto deep = decodePicture(pictureFileOf(cv::Mat(3, 5, CV_16UC1, cv::Scalar(29'815)), ".png"));
    ASSERT_TRUE(deep) << deep.error().text;
    EXPECT_EQ(deep->pixel, Pixel::Grey16);
    EXPECT_EQ(valuesOf<std::uint16_t>(*deep).front(), 29'815);
    const auto both = decodePicture(pictureFileOf(cv::Mat(3, 5, CV_16UC3, cv::Scalar(0, 0, 65'535)), ".png"));
    EXPECT_EQ(valuesOf(*both).front(), 255);
}

/// The file with another size in its header; its checksum is wrong then, which nobody asks first.
PictureSample withSize(const PictureSample& sample, std::uint32_t width, std::uint32_t height) {
    std::vector<std::byte> bytes(sample.content.bytes.begin(), sample.content.bytes.end());
    const bool png = pictureFileKind(bytes) == PictureFileKind::Png;
    std::size_t at = png ? 16 : 2;
    if (!png) {
        const auto value = [&](std::size_t i) { return std::to_integer<std::size_t>(bytes[i]); };
        while (value(at + 1) != 0xc0) at += 2 + (value(at + 2) << 8 | value(at + 3));
        at += 5;
        std::swap(width, height);
    }
    for (const std::uint32_t value : {width, height}) {
        for (int shift = png ? 24 : 8; shift >= 0; shift -= 8)
            bytes[at++] = static_cast<std::byte>(value >> shift);
    }
    return pictureFile(std::move(bytes));
}

TEST(PictureFiles, BombsAreRefusedByTheirHeaders) {
    const cv::Mat mat(8, 8, CV_8UC3, cv::Scalar(1, 2, 3));
    const PictureSample png = pictureFileOf(mat, ".png"), jpeg = pictureFileOf(mat, ".jpg");
    EXPECT_THAT(pictureError(withSize(png, 2'000'000'000, 2'000'000'000)), HasSubstr("2000000000 x"));
    EXPECT_THAT(pictureError(withSize(jpeg, 65'535, 65'535)), HasSubstr("65535 x 65535"));
    EXPECT_THAT(pictureError(withSize(png, 16'000, 16'000)), HasSubstr("at most 16777216"));
    EXPECT_THAT(pictureError(withSize(png, 0, 8)), HasSubstr("some size"));
    EXPECT_THAT(pictureError(png, {4, 100}), HasSubstr("8 x 8"));
}

TEST(PictureFiles, DamagedOnesNeverHarm) {
    std::mt19937 random(3);
    cv::Mat mat(24, 32, CV_8UC3);
    for (int y = 0; y < mat.rows; ++y) {
        for (int x = 0; x < 3 * mat.cols; ++x) mat.ptr(y)[x] = static_cast<unsigned char>(random());
    }
    for (const char* ending : {".png", ".jpg"}) {
        const PictureSample whole = pictureFileOf(mat, ending);
        const auto& content = whole.content.bytes;
        for (std::size_t size = 0; size < 60; ++size) {
            const auto cut = content.first(size);
            EXPECT_NE(pictureError(pictureFile({cut.begin(), cut.end()})), "none") << ending << " " << size;
        }
        std::uniform_int_distribution<std::size_t> place(2, content.size() - 1);
        for (int i = 0; i < 200; ++i) {
            std::vector<std::byte> bytes(content.begin(), content.end());
            for (int flip = 0; flip < 3; ++flip) bytes[place(random)] = static_cast<std::byte>(random());
            const auto picture = decodePicture(pictureFile(std::move(bytes)), {64, 4096});
            if (!picture) continue;
            EXPECT_EQ(picture->bytes.size(), static_cast<std::size_t>(picture->width) *
                                                 static_cast<std::size_t>(picture->height) *
                                                 picture->pixelSize());
        }
    }
}

TEST(Temperatures, FollowTheScale) {
    const auto picture = decodePicture(pictureFileOf(cv::Mat(2, 2, CV_16UC1, cv::Scalar(31'015)), ".png"));
    ASSERT_TRUE(picture);
    const auto thermal = temperatures(*picture, {0.01, 0.0, true});
    ASSERT_TRUE(thermal) << thermal.error().text;
    EXPECT_EQ(thermal->width, 2);
    EXPECT_NEAR(thermal->celsius.front(), 37.0, 1e-4);
    EXPECT_NEAR(temperatures(*picture, {0.04, -300.0, true})->celsius.front(), 31'015 * 0.04 - 573.15, 1e-3);
    EXPECT_TRUE(std::isnan(temperatures(*picture, {-1.0, 0.0, true})->celsius.front())) << "below 0 K";
}

TEST(Temperatures, AreNotReadFromColours) {
    const auto grey = decodePicture(pictureFileOf(cv::Mat(2, 2, CV_16UC1, cv::Scalar(31'015)), ".png"));
    EXPECT_THAT(temperatures(*grey, {0.01, 0.0, false}).error().text, HasSubstr("mapped"));
    const auto colour = decodePicture(pictureFileOf(cv::Mat(2, 2, CV_8UC3, cv::Scalar(1, 2, 3)), ".png"));
    EXPECT_THAT(temperatures(*colour, {}).error().text, HasSubstr("colours"));
}

}  // namespace
}  // namespace leitstand::test
