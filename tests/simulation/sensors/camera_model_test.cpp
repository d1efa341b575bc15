#include <cmath>

#include <gtest/gtest.h>

#include "core/base/pose.h"
#include "robots/simulation/sensors/camera/camera_model.h"

namespace leitstand::simulation {
namespace {

TEST(CameraModel, ProjectsToThePixelOfEachDirection) {
    for (const CameraModel& camera : {pinholeCamera(), infraredOptics(), omnidirectionalCamera()}) {
        int seen = 0;
        for (int v = 0; v < camera.height; v += 7) {
            for (int u = 0; u < camera.width; u += 7) {
                const auto direction = camera.direction({u, v});
                if (!direction) continue;
                ++seen;
                EXPECT_NEAR(direction->norm(), 1.0, 1e-12);
                const auto pixel = camera.project(3.7 * *direction);
                ASSERT_TRUE(pixel);
                EXPECT_NEAR((*pixel - Eigen::Vector2d(u, v)).norm(), 0.0, 1e-6);
            }
        }
        EXPECT_GT(seen, camera.mirror ? 1300 : 300);
    }
}

TEST(CameraModel, IsOpenCvsPinholeWithItsDistortion) {
    const CameraModel camera = pinholeCamera();
    const double x = 0.2, y = -0.15, r2 = x * x + y * y;
    const double radial = 1 + camera.k1 * r2 + camera.k2 * r2 * r2;
    const double u =
        camera.fx * (x * radial + 2 * camera.p1 * x * y + camera.p2 * (r2 + 2 * x * x)) + camera.cx;
    const double v =
        camera.fy * (y * radial + camera.p1 * (r2 + 2 * y * y) + 2 * camera.p2 * x * y) + camera.cy;
    EXPECT_TRUE(camera.project({2 * x, 2 * y, 2})->isApprox(Eigen::Vector2d(u, v), 1e-12));
    EXPECT_FALSE(camera.project({0, 0, -1}));
}

TEST(CameraModel, OfTheMirrorSeesAllAroundButNotItself) {
    const CameraModel camera = omnidirectionalCamera();
    EXPECT_FALSE(camera.project({0, 0, 1})) << "itself";
    for (int i = 0; i < 36; ++i) {
        const double angle = degrees(10.0 * i);
        const Eigen::Vector3d level(std::cos(angle), std::sin(angle), 0.0);
        const auto pixel = camera.project(level);
        ASSERT_TRUE(pixel);
        EXPECT_GT(pixel->x(), 0);
        EXPECT_LT(pixel->x(), camera.width - 1);
        EXPECT_GT(pixel->y(), 0);
        EXPECT_LT(pixel->y(), camera.height - 1);
        EXPECT_TRUE(camera.project(level - Eigen::Vector3d(0, 0, std::tan(degrees(14)))));
        EXPECT_FALSE(camera.project(level - Eigen::Vector3d(0, 0, std::tan(degrees(16)))));
    }
}

TEST(CameraModel, TellsItsCalibration) {
    const CameraInfoSample mirror = omnidirectionalCamera().info({});
    EXPECT_EQ(mirror.distortionModel, "mei");
    ASSERT_EQ(mirror.distortion.size(), 5U);
    EXPECT_EQ(mirror.distortion[4], 0.95) << "xi";
    const CameraInfoSample pinhole = pinholeCamera().info({});
    EXPECT_EQ(pinhole.distortionModel, "plumb_bob");
    EXPECT_EQ(pinhole.intrinsics[2], pinholeCamera().cx);
}

TEST(CameraModel, ShrinksWithItsPictures) {
    const CameraModel camera = pinholeCamera(), half = camera.scaledTo(160);
    EXPECT_EQ(half.width, 160);
    EXPECT_EQ(half.height, 120);
    const Eigen::Vector3d point(0.3, 0.2, 1.1);
    const Eigen::Vector2d whole = *camera.project(point);
    EXPECT_TRUE(
        half.project(point)->isApprox((whole.array() + 0.5).matrix() / 2 - Eigen::Vector2d(0.5, 0.5)));
    EXPECT_EQ(camera.scaledTo(0).width, 320);
    EXPECT_EQ(camera.scaledTo(1000).width, 320);
}

}  // namespace
}  // namespace leitstand::simulation
