#include "core/perception/heat/heat.h"

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/picture_samples.h"
#include "core/perception/pictures/pixel_ray.h"

namespace leitstand::test {
namespace {

using Kind = HeatBlob::Kind;

/// 160 x 120, 40 degrees across.
CameraInfoSample camera() {
    CameraInfoSample info;
    info.width = 160;
    info.height = 120;
    const double focal = 80.0 / std::tan(degrees(20));
    info.intrinsics = {focal, 0, 79.5, 0, focal, 59.5, 0, 0, 1};
    return info;
}

/// A picture of a place at 20 degrees with noise of 0.1 K, blurred by a pixel like a real lens.
class Warm {
public:
    Warm() : m_celsius(160 * 120, 20.0F) {}
    Warm& disc(double x, double y, double radius, float celsius) {
        return paint(celsius, [=](double u, double v) { return std::hypot(u - x, v - y) <= radius; });
    }
    Warm& box(double left, double top, double right, double bottom, float celsius) {
        return paint(celsius,
                     [=](double u, double v) { return u >= left && u < right && v >= top && v < bottom; });
    }
    [[nodiscard]] std::vector<HeatBlob> find(const HeatSettings& settings = {}) const {
        ThermalPicture picture{160, 120, m_celsius};
        std::mt19937 random(4);
        std::normal_distribution<float> noise(0.0F, 0.1F);
        for (int y = 0; y < 120; ++y) {
            for (int x = 0; x < 160; ++x) {
                float sum = 0.0F;
                for (int v = -1; v <= 1; ++v) {
                    for (int u = -1; u <= 1; ++u)
                        sum += at(x + u, y + v) * static_cast<float>((2 - u * u) * (2 - v * v));
                }
                picture.celsius[static_cast<std::size_t>(y * 160 + x)] = sum / 16.0F + noise(random);
            }
        }
        return findHeat(picture, camera(), settings);
    }

private:
    template <class Inside>
    Warm& paint(float celsius, const Inside& inside) {
        for (int i = 0; i < 160 * 120; ++i) {
            if (inside(i % 160 + 0.5, i / 160 + 0.5)) m_celsius[static_cast<std::size_t>(i)] = celsius;
        }
        return *this;
    }
    [[nodiscard]] float at(int x, int y) const {
        return m_celsius[static_cast<std::size_t>(std::clamp(y, 0, 119) * 160 + std::clamp(x, 0, 159))];
    }
    std::vector<float> m_celsius;
};

std::vector<Kind> kinds(const std::vector<HeatBlob>& blobs) {
    std::vector<Kind> found;
    for (const HeatBlob& blob : blobs) found.push_back(blob.kind);
    return found;
}

TEST(Heat, FindsABodyWhereItIs) {
    const auto blobs = Warm().disc(100.0, 40.0, 8.0, 33.0F).find();
    ASSERT_THAT(kinds(blobs), testing::ElementsAre(Kind::Body));
    EXPECT_NEAR(blobs[0].centre.x(), 100.0, 0.2);
    EXPECT_NEAR(blobs[0].centre.y(), 40.0, 0.2);
    EXPECT_NEAR(blobs[0].mean, 32.3, 0.5);
    EXPECT_NEAR(blobs[0].peak, 33.3, 0.3);
    EXPECT_NEAR(blobs[0].size, std::sqrt(3.1416 * 64) / 219.8, 0.006);
    EXPECT_NEAR(blobs[0].width, 16.0 / 219.8, 0.01);
    EXPECT_FALSE(blobs[0].cut);
    EXPECT_GT(blobs[0].confidence, 0.7);
}

TEST(Heat, NothingInNoise) {
    EXPECT_TRUE(Warm().find().empty());
}

TEST(Heat, ALampIsNoBodyNorIsItsRim) {
    EXPECT_THAT(kinds(Warm().disc(80, 60, 5.0, 90.0F).find()), testing::ElementsAre(Kind::Lamp));
    EXPECT_THAT(kinds(Warm().disc(80, 60, 2.0, 120.0F).find()), testing::ElementsAre(Kind::Lamp));
}

TEST(Heat, AHeaterIsNoBodyNorIsItsRim) {
    EXPECT_THAT(kinds(Warm().box(20, 40, 90, 100, 55.0F).find()), testing::ElementsAre(Kind::Heater));
}

TEST(Heat, ABodyBesideAHeaterIsFound) {
    const auto blobs = Warm().box(20, 40, 60, 90, 55.0F).box(60, 60, 90, 90, 33.0F).find();
    ASSERT_THAT(kinds(blobs), testing::ElementsAre(Kind::Body, Kind::Heater));
    EXPECT_NEAR(blobs[0].centre.x(), 76.0, 2.0);
}

TEST(Heat, TinySpotsAndWarmWallsAreNoBodies) {
    EXPECT_TRUE(Warm().disc(80.5, 60.5, 0.6, 38.0F).find().empty());
    HeatSettings settings;
    settings.contrast = -20.0;
    EXPECT_THAT(kinds(Warm().box(0, 0, 160, 120, 32.0F).find()), testing::IsEmpty()) << "no contrast";
    settings.maxSize = 0.4;
    EXPECT_THAT(kinds(Warm().box(0, 0, 160, 120, 32.0F).find(settings)), testing::ElementsAre(Kind::Other));
}

// Near by it fills most of the picture; it vanished just when a robot stood before it.
TEST(Heat, WhatFillsTwoThirdsOfThePictureIsFound) {
    const auto blobs = Warm().box(10, 8, 150, 110, 33.0F).find();
    ASSERT_EQ(blobs.size(), 1U);
    EXPECT_EQ(blobs[0].kind, Kind::Body);
    EXPECT_NEAR(blobs[0].pixels, 140 * 102, 600);
}

TEST(Heat, ASmallHandFarAwayIsABody) {
    const auto blobs = Warm().box(80, 60, 85, 65, 35.0F).find();
    ASSERT_THAT(kinds(blobs), testing::ElementsAre(Kind::Body));
    EXPECT_LT(blobs[0].confidence, 0.7) << "but not for sure";
}

TEST(Heat, ADeadBodyAtTheTemperatureOfTheRoomIsNotSeen) {
    EXPECT_TRUE(Warm().disc(80, 60, 10, 20.5F).find().empty());
}

TEST(Heat, TheMostConvincingComesFirst) {
    const auto blobs = Warm().box(20, 20, 26, 26, 31.0F).disc(110, 70, 12, 34.0F).find();
    ASSERT_EQ(blobs.size(), 2U);
    EXPECT_NEAR(blobs[0].centre.x(), 110.0, 0.3);
}

TEST(Heat, ABodyAtTheBorderIsMarkedCut) {
    const auto blobs = Warm().disc(0, 60, 10, 33.0F).find();
    ASSERT_EQ(blobs.size(), 1U);
    EXPECT_TRUE(blobs[0].cut);
}

TEST(Heat, HoldsPicturesThatAreNone) {
    EXPECT_TRUE(findHeat({}, camera()).empty());
    EXPECT_TRUE(findHeat({160, 120, {}}, camera()).empty());
    EXPECT_TRUE(findHeat({-3, 2, {}}, camera()).empty());
    EXPECT_TRUE(findHeat({2, 2, std::vector<float>(4, std::nanf(""))}, {}).empty());
}

TEST(PixelRay, GoesThroughThePixel) {
    const auto middle = pixelDirection(camera(), {80.0, 60.0}, 160, 120);
    ASSERT_TRUE(middle);
    EXPECT_TRUE(middle->isApprox(Eigen::Vector3d::UnitZ(), 1e-9));
    const auto right = pixelDirection(camera(), {160.0, 60.0}, 160, 120);
    ASSERT_TRUE(right);
    EXPECT_NEAR(std::atan2(right->x(), right->z()), degrees(20), 1e-9);
    const auto reduced = pixelDirection(camera(), {80.0, 30.0}, 80, 60);
    ASSERT_TRUE(reduced);
    EXPECT_TRUE(reduced->isApprox(*right, 1e-9)) << "the same place of a smaller picture";

    const Pose optical = opticalFrame(poseFrom({0.1, -0.2, 0.5}, 0.0, 0.0, degrees(90)));
    const Ray ray = rayFrom(optical, *right);
    EXPECT_TRUE(ray.origin.isApprox(Eigen::Vector3d(0.1, -0.2, 0.5)));
    EXPECT_NEAR(std::atan2(ray.direction.y(), ray.direction.x()), degrees(70), 1e-9)
        << "to the right of a camera that looks left";
}

TEST(PixelRay, TakesDistortionOut) {
    CameraInfoSample info = camera();
    info.distortionModel = "plumb_bob";
    info.distortion = {-0.3, 0.1, 0.001, -0.002, 0.0};
    const Eigen::Vector2d point(0.25, -0.15);
    const double r2 = point.squaredNorm();
    const double radial = 1.0 - 0.3 * r2 + 0.1 * r2 * r2;
    const double xy = point.x() * point.y();
    const Eigen::Vector2d seen(
        point.x() * radial + 2 * 0.001 * xy - 0.002 * (r2 + 2 * point.x() * point.x()),
        point.y() * radial + 0.001 * (r2 + 2 * point.y() * point.y()) - 2 * 0.002 * xy);
    const double focal = info.intrinsics[0];
    const auto ray = pixelDirection(info, {focal * seen.x() + 80.0, focal * seen.y() + 60.0}, 160, 120);
    ASSERT_TRUE(ray);
    EXPECT_NEAR(ray->x() / ray->z(), point.x(), 1e-6);
    EXPECT_NEAR(ray->y() / ray->z(), point.y(), 1e-6);
}

TEST(PixelRay, SaysNothingOfCamerasThatItDoesNotKnow) {
    EXPECT_FALSE(pixelDirection({}, {80, 60}, 160, 120));
    CameraInfoSample mei = camera();
    mei.distortionModel = "mei";
    EXPECT_FALSE(pixelDirection(mei, {80, 60}, 160, 120));
    EXPECT_FALSE(pixelDirection(camera(), {80, 60}, 0, 120));
}

}  // namespace
}  // namespace leitstand::test
