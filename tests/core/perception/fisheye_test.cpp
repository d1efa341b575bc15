// Cameras with fisheye lenses: where a pixel looks, and where a direction is shown.
#include <cmath>

#include <gtest/gtest.h>

#include "core/base/pose.h"
#include "core/event/picture_samples.h"
#include "core/perception/pictures/pixel_ray.h"

namespace leitstand::test {
namespace {

/// As a RealSense T265 is calibrated.
CameraInfoSample fisheye() {
    CameraInfoSample camera;
    camera.width = 848;
    camera.height = 800;
    camera.distortionModel = "equidistant";
    camera.distortion = {-0.0074, 0.0437, -0.0413, 0.0075};
    camera.intrinsics = {285.7, 0.0, 416.6, 0.0, 285.9, 403.7, 0.0, 0.0, 1.0};
    return camera;
}

TEST(Fisheye, AnAngleIsShownByThePolynomialOfItsCalibration) {
    // theta (1 + k1 theta^2 + ... + k4 theta^8) x f, for 60 degrees to the right.
    const double angle = degrees(60.0), a2 = angle * angle;
    const double shown = angle * (1.0 + a2 * (-0.0074 + a2 * (0.0437 + a2 * (-0.0413 + a2 * 0.0075))));
    const auto pixel = pixelOf(fisheye(), {std::sin(angle), 0.0, std::cos(angle)}, 848, 800);
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x(), 285.7 * shown + 416.6 + 0.5, 1e-9);
    EXPECT_NEAR(pixel->y(), 403.7 + 0.5, 1e-9);
}

TEST(Fisheye, EachPixelLooksWhereItIsShown) {
    for (const double x : {10.0, 120.0, 417.1, 600.0, 840.0}) {
        for (const double y : {200.0, 404.2, 700.0}) {
            const auto direction = pixelDirection(fisheye(), {x, y}, 848, 800);
            ASSERT_TRUE(direction) << x << ", " << y;
            EXPECT_NEAR(direction->norm(), 1.0, 1e-12);
            const auto pixel = pixelOf(fisheye(), *direction, 848, 800);
            ASSERT_TRUE(pixel);
            EXPECT_NEAR((*pixel - Eigen::Vector2d(x, y)).norm(), 0.0, 1e-4) << x << ", " << y;
        }
    }
}

TEST(Fisheye, ItSeesBesideAndBehindItself) {
    CameraInfoSample camera = fisheye();
    camera.distortion = {0.0, 0.0, 0.0, 0.0};
    const auto beside = pixelOf(camera, {1.0, 0.0, 0.0}, 848, 800);
    ASSERT_TRUE(beside);
    EXPECT_NEAR(beside->x(), 285.7 * degrees(90.0) + 417.1, 1e-9);
    const auto behind = pixelDirection(camera, {285.7 * degrees(100.0) + 417.1, 404.2}, 848, 800);
    ASSERT_TRUE(behind);
    EXPECT_LT(behind->z(), 0.0);
}

TEST(Fisheye, WhereTheLensShowsNothingIsNoDirection) {
    EXPECT_FALSE(pixelDirection(fisheye(), {20'000.0, 400.0}, 848, 800));
    CameraInfoSample camera = fisheye();
    camera.distortion = {-1.0, 0.0, 0.0, 0.0};  // folds back at 33 degrees
    EXPECT_FALSE(pixelDirection(camera, {840.0, 404.2}, 848, 800));
    EXPECT_FALSE(pixelOf(camera, {1.0, 0.0, 0.3}, 848, 800));
    camera = fisheye();
    camera.distortion.assign(4, std::nan(""));
    EXPECT_FALSE(pixelDirection(camera, {500.0, 500.0}, 848, 800));
}

TEST(Fisheye, SmallerPicturesOfItSeeTheSame) {
    const auto whole = pixelDirection(fisheye(), {600.0, 500.0}, 848, 800);
    const auto half = pixelDirection(fisheye(), {300.0, 250.0}, 424, 400);
    ASSERT_TRUE(whole && half);
    EXPECT_NEAR((*whole - *half).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace leitstand::test
