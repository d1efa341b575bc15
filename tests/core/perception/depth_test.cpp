// Depth pictures: clouds from them, raw or compressed, and what is wrong with them.
#include <cmath>
#include <cstring>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/perception/depth/depth_cloud.h"
#include "core/perception/pictures/coding/picture_decoding.h"
#include "core/perception/pictures/coding/picture_png.h"
#include "tests/core/perception/pictures.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

constexpr int Width = 64, Height = 48;
constexpr std::size_t Pixels = std::size_t{Width} * Height;

std::size_t indexOf(int x, int y) {
    return static_cast<std::size_t>(y) * Width + static_cast<std::size_t>(x);
}

/// A camera that sees 90 degrees across.
CameraInfoSample depthCamera() {
    CameraInfoSample info;
    info.width = Width;
    info.height = Height;
    info.distortionModel = "plumb_bob";
    info.distortion = {0, 0, 0, 0, 0};
    info.intrinsics = {32.0, 0.0, 31.5, 0.0, 32.0, 23.5, 0.0, 0.0, 1.0};
    return info;
}

template <class T>
std::vector<std::byte> bytesOfAll(const std::vector<T>& values) {
    std::vector<std::byte> bytes(values.size() * sizeof(T));
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

/// Depths of a wall at 2 m [mm], with a box at 1 m before its middle.
std::vector<std::uint16_t> wallAndBox() {
    std::vector<std::uint16_t> depths(Pixels, 2'000);
    for (int y = 16; y < 32; ++y)
        for (int x = 20; x < 40; ++x) depths[indexOf(x, y)] = 1'000;
    return depths;
}

PictureSample rawDepths(const std::vector<std::uint16_t>& depths) {
    PictureSample sample = rawPicture("16UC1", Width, Height, std::size_t{2} * Width, bytesOfAll(depths));
    sample.header.frame = "optical";
    return sample;
}

PictureSample depthFile(const std::string& format, float a, float b, const std::vector<std::byte>& content) {
    std::vector<std::byte> bytes(4);
    for (const float parameter : {a, b}) {
        const auto more = bytesOfAll(std::vector<float>{parameter});
        bytes.insert(bytes.end(), more.begin(), more.end());
    }
    bytes.insert(bytes.end(), content.begin(), content.end());
    PictureSample sample = pictureFile(std::move(bytes));
    sample.encoding = format;
    return sample;
}

std::vector<std::byte> pngOf(const std::vector<std::uint16_t>& values) {
    const Picture picture{Width, Height, Picture::Pixel::Grey16, bytesOfAll(values)};
    return encodePng(picture).value();
}

/// RVL as its paper has it: runs of zeros and of values; differences, the sign last, in parts of three bits.
std::vector<std::byte> rvlOf(const std::vector<std::uint16_t>& values) {
    std::vector<std::uint32_t> words;
    int parts = 0;
    const auto put = [&](std::uint32_t number) {
        do {
            if (parts % 8 == 0) words.push_back(0);
            const std::uint32_t part = (number & 7U) | (number > 7U ? 8U : 0U);
            words.back() |= part << (28U - 4U * static_cast<unsigned>(parts % 8));
            number >>= 3U;
            ++parts;
        } while ((words.back() >> (28U - 4U * static_cast<unsigned>((parts - 1) % 8)) & 8U) != 0);
    };
    int last = 0;
    for (std::size_t at = 0; at < values.size();) {
        std::size_t zeros = at;
        while (zeros < values.size() && values[zeros] == 0) ++zeros;
        put(static_cast<std::uint32_t>(zeros - at));
        std::size_t end = zeros;
        while (end < values.size() && values[end] != 0) ++end;
        put(static_cast<std::uint32_t>(end - zeros));
        for (std::size_t i = zeros; i < end; ++i) {
            const int change = values[i] - last;
            put(static_cast<std::uint32_t>(change < 0 ? -2 * change - 1 : 2 * change));
            last = values[i];
        }
        at = end;
    }
    std::vector<std::byte> bytes = bytesOfAll(std::vector<std::int32_t>{Width, Height});
    const auto more = bytesOfAll(words);
    bytes.insert(bytes.end(), more.begin(), more.end());
    return bytes;
}

std::vector<std::uint16_t> depthsIn(const Picture& picture) {
    std::vector<std::uint16_t> values(picture.bytes.size() / 2);
    std::memcpy(values.data(), picture.bytes.data(), picture.bytes.size());
    return values;
}

TEST(DepthCloud, PointsLieWhereTheirPixelsLook) {
    DepthCloud clouds;
    const auto cloud = clouds.of(rawDepths(wallAndBox()), depthCamera());
    ASSERT_TRUE(cloud) << cloud.error().text;
    EXPECT_EQ(cloud->header.frame, "optical");
    EXPECT_FALSE(cloud->organised());
    double most = 0.0;
    int near = 0;
    for (const Eigen::Vector3f& point : cloud->points) {
        const bool box = point.z() < 1.5F;
        EXPECT_FLOAT_EQ(point.z(), box ? 1.0F : 2.0F);
        near += box ? 1 : 0;
        most = std::max(most, static_cast<double>(point.x()));
        if (box) {
            EXPECT_LE(std::abs(point.x()), 0.37F);
        }
    }
    EXPECT_NEAR(most, 2.0 * 31.5 / 32.0, 1e-5) << "the last pixel of a row";
    EXPECT_NEAR(near, 20 * 16, 80) << "but for its edges";
    EXPECT_GT(cloud->points.size(), Width * Height * 0.9);
}

TEST(DepthCloud, WhatCamerasMakeUpAtEdgesIsLeftOut) {
    auto depths = wallAndBox();
    for (int y = 0; y < Height; ++y) depths[indexOf(10, y)] = y % 2 == 0 ? 1'500 : 2'600;
    DepthCloud clouds;
    const auto cloud = clouds.of(rawDepths(depths), depthCamera());
    ASSERT_TRUE(cloud);
    for (const Eigen::Vector3f& point : cloud->points)
        EXPECT_TRUE(point.z() == 1.0F || point.z() == 2.0F) << point.transpose();
}

TEST(DepthCloud, LargePicturesAreThinnedAndTooNearOrFarIsNothing) {
    DepthSettings settings;
    settings.mostPoints = 200;
    DepthCloud clouds(settings);
    EXPECT_LE(clouds.of(rawDepths(wallAndBox()), depthCamera())->points.size(), 220U);
    for (const int depth : {0, 100, 9'000})
        EXPECT_TRUE(clouds
                        .of(rawDepths(std::vector<std::uint16_t>(Pixels, static_cast<std::uint16_t>(depth))),
                            depthCamera())
                        ->points.empty());
}

TEST(DepthCloud, MetresAreUnderstoodToo) {
    std::vector<float> depths(Pixels, 2.0F);
    depths[5] = std::nanf("");
    depths[6] = INFINITY;
    depths[7] = -1.0F;
    DepthCloud clouds;
    const auto cloud = clouds.of(
        rawPicture("32FC1", Width, Height, std::size_t{4} * Width, bytesOfAll(depths)), depthCamera());
    ASSERT_TRUE(cloud) << cloud.error().text;
    EXPECT_EQ(cloud->points.size(), depths.size() - 3);
}

TEST(DepthCloud, ColoursAndCamerasWithoutCalibrationAreRefused) {
    DepthCloud clouds;
    const PictureSample colours = rawPicture("mono8", 8, 8, 8, std::vector<std::byte>(64));
    EXPECT_THAT(clouds.of(colours, depthCamera()).error().text, HasSubstr("16UC1"));
    EXPECT_THAT(clouds.of(rawDepths(wallAndBox()), CameraInfoSample{}).error().text,
                HasSubstr("camera_info"));
}

TEST(DepthFile, PngAndRvlHoldTheSameDepths) {
    auto depths = wallAndBox();
    std::fill(depths.begin() + 100, depths.begin() + 400, std::uint16_t{0});
    depths.back() = 0;
    for (const auto& [format, content] :
         {std::pair(std::string("16UC1; compressedDepth png"), pngOf(depths)),
          std::pair(std::string("16UC1; compressedDepth"), pngOf(depths)),
          std::pair(std::string("16UC1; compressedDepth rvl"), rvlOf(depths))}) {
        const auto picture = decodePicture(depthFile(format, 0, 0, content));
        ASSERT_TRUE(picture) << format << ": " << picture.error().text;
        EXPECT_EQ(picture->pixel, Picture::Pixel::Grey16);
        EXPECT_EQ(depthsIn(*picture), depths) << format;
    }
}

TEST(DepthFile, InverseDepthsBecomeMetres) {
    // depth = A / (value - B): 1000 / (600 - 100) = 2 m
    std::vector<std::uint16_t> values(Pixels, 600);
    values[0] = 0;
    const auto picture =
        decodePicture(depthFile("32FC1; compressedDepth png", 1000.0F, 100.0F, pngOf(values)));
    ASSERT_TRUE(picture) << picture.error().text;
    ASSERT_EQ(picture->pixel, Picture::Pixel::Float32);
    std::vector<float> depths(Pixels);
    std::memcpy(depths.data(), picture->bytes.data(), picture->bytes.size());
    EXPECT_TRUE(std::isnan(depths[0]));
    EXPECT_FLOAT_EQ(depths[1], 2.0F);
}

TEST(DepthFile, WhatIsDamagedIsRefused) {
    const auto rvl = rvlOf(wallAndBox());
    const auto refuses = [](const std::string& format, const std::vector<std::byte>& content) {
        return !decodePicture(depthFile(format, 0, 0, content)).ok();
    };
    for (std::size_t size = 0; size + 4 < rvl.size(); size += 7)
        EXPECT_TRUE(refuses("16UC1; compressedDepth rvl", {rvl.begin(), rvl.begin() + std::ptrdiff_t(size)}))
            << size;
    auto huge = rvl;
    for (int i = 0; i < 8; ++i) huge[static_cast<std::size_t>(i)] = std::byte{0x7f};
    EXPECT_TRUE(refuses("16UC1; compressedDepth rvl", huge));
    EXPECT_TRUE(refuses("16UC1; compressedDepth png", {}));
    EXPECT_TRUE(refuses("16UC1; compressedDepth png", rvl));
    std::mt19937 random(3);
    for (int i = 0; i < 500; ++i) {
        auto content = rvl;
        for (int k = 0; k < 4; ++k)
            content[8 + random() % (content.size() - 8)] = static_cast<std::byte>(random());
        (void)decodePicture(depthFile("16UC1; compressedDepth rvl", 0, 0, content));  // hurts nothing
    }
}

}  // namespace
}  // namespace leitstand::test
