#include "widgets/camera/picture_image.h"

#include <cstring>
#include <limits>

#include <gtest/gtest.h>

namespace leitstand {
namespace {

Picture pictureOf(Picture::Pixel pixel, int width, int height, const void* bytes) {
    Picture picture{width, height, pixel, {}};
    picture.bytes.resize(static_cast<std::size_t>(width * height) * picture.pixelSize());
    std::memcpy(picture.bytes.data(), bytes, picture.bytes.size());
    return picture;
}

TEST(PictureImage, KeepsColoursAndGreys) {
    const unsigned char rgb[] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 10, 20, 30, 1, 2, 3, 4, 5, 6};
    const QImage colours = imageOf(pictureOf(Picture::Pixel::Rgb8, 3, 2, rgb));
    ASSERT_EQ(colours.size(), QSize(3, 2));
    EXPECT_EQ(colours.pixel(0, 0), qRgb(255, 0, 0));
    EXPECT_EQ(colours.pixel(2, 0), qRgb(0, 0, 255));
    EXPECT_EQ(colours.pixel(0, 1), qRgb(10, 20, 30));
    const unsigned char grey[] = {0, 100, 255};
    EXPECT_EQ(imageOf(pictureOf(Picture::Pixel::Grey8, 3, 1, grey)).pixel(1, 0), qRgb(100, 100, 100));
}

TEST(PictureImage, SpreadsNumbers) {
    const std::uint16_t numbers[] = {1000, 2000, 3000};
    const QImage image = imageOf(pictureOf(Picture::Pixel::Grey16, 3, 1, numbers));
    EXPECT_EQ(qGray(image.pixel(0, 0)), 0);
    EXPECT_EQ(qGray(image.pixel(1, 0)), 128);
    EXPECT_EQ(qGray(image.pixel(2, 0)), 255);
    const float flat[] = {5.0F, 5.0F, std::numeric_limits<float>::quiet_NaN()};
    EXPECT_EQ(qGray(imageOf(pictureOf(Picture::Pixel::Float32, 3, 1, flat)).pixel(2, 0)), 0);
}

TEST(PictureImage, IsNullWhenSizesDoNotFit) {
    Picture picture{3, 2, Picture::Pixel::Grey8, std::vector<std::byte>(5)};
    EXPECT_TRUE(imageOf(picture).isNull());
    EXPECT_TRUE(imageOf(Picture{}).isNull());
    EXPECT_TRUE(imageOf(Picture{-1, 4, Picture::Pixel::Grey8, {}}).isNull());
    EXPECT_TRUE(imageOf(ThermalPicture{2, 2, {1.0F}}).isNull());
}

TEST(ThermalImage, AColourKeepsItsTemperature) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const ThermalPicture cold{2, 1, {20.0F, 21.0F}}, hot{2, 2, {20.0F, 39.0F, nan, 1e9F}};
    EXPECT_EQ(imageOf(cold).pixel(0, 0), imageOf(hot).pixel(0, 0));
    const QImage image = imageOf(hot, {}, ThermalPalette::GreyHot);
    EXPECT_LT(qGray(image.pixel(0, 0)), qGray(image.pixel(1, 0)));
    EXPECT_EQ(image.pixel(0, 1), qRgb(96, 96, 96)) << "nothing measured";
    EXPECT_EQ(image.pixel(1, 1), qRgb(255, 255, 255));
    int before = -1;
    for (float celsius = 15.0F; celsius <= 40.0F; celsius += 0.5F) {
        const int light = qGray(thermalColour(celsius, {}, ThermalPalette::Iron));
        EXPECT_GE(light, before) << celsius << ": hotter is lighter";
        before = light;
    }
}

TEST(ThermalImage, TellsTheValueUnderThePointer) {
    const ThermalPicture picture{2, 2, {1.0F, 2.0F, 3.0F, std::numeric_limits<float>::quiet_NaN()}};
    EXPECT_EQ(celsiusAt(picture, 0.0, 0.0), 1.0F);
    EXPECT_EQ(celsiusAt(picture, 0.99, 0.1), 2.0F);
    EXPECT_EQ(celsiusAt(picture, 0.1, 0.99), 3.0F);
    EXPECT_EQ(celsiusAt(picture, 0.9, 0.9), std::nullopt);
    EXPECT_EQ(celsiusAt(picture, 1.0, 0.5), std::nullopt);
    EXPECT_EQ(celsiusAt(picture, -0.1, 0.5), std::nullopt);
    EXPECT_EQ(celsiusAt(ThermalPicture{}, 0.5, 0.5), std::nullopt);
    EXPECT_EQ(rangeOf(picture).coolest, 1.0F);
    EXPECT_EQ(rangeOf(picture).hottest, 3.0F);
    EXPECT_NEAR(rangeOf({1, 1, {20.0F}}).hottest, 21.0F, 1e-5F);
}

}  // namespace
}  // namespace leitstand
