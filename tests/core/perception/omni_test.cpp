#include <cmath>
#include <cstring>
#include <numbers>

#include <gtest/gtest.h>

#include "core/event/picture_samples.h"
#include "core/perception/omni/mei_camera.h"
#include "core/perception/omni/panorama.h"

namespace leitstand {
namespace {

constexpr int Side = 960;

/// A mirror in pictures of Side x Side with some of every distortion.
CameraInfoSample mirror(double xi = 0.95) {
    CameraInfoSample info;
    info.width = info.height = Side;
    info.distortionModel = "mei";
    info.distortion = {-0.02, 0.004, 0.0006, -0.0004, xi};
    info.intrinsics = {330, 0, 480.9, 0, 331, 476.7, 0, 0, 1};
    return info;
}

/// Below the mirror of a robot, its z straight down, the top of its picture ahead; @p turned to the left.
Pose lookingDown(double turned = 0.0) {
    Pose pose = poseFrom({0.0, 0.0, 0.34}, degrees(180), 0.0, degrees(-90) + turned);
    return pose;
}

Eigen::Vector3d towards(double yaw, double elevation) {
    return {std::cos(elevation) * std::cos(yaw), std::cos(elevation) * std::sin(yaw), std::sin(elevation)};
}

/// The formulas of the paper, written once more.
Eigen::Vector2d byThePaper(const CameraInfoSample& info, const Eigen::Vector3d& direction) {
    const Eigen::Vector3d onSphere = direction.normalized();
    const auto& d = info.distortion;
    const double x = onSphere.x() / (onSphere.z() + d[4]), y = onSphere.y() / (onSphere.z() + d[4]);
    const double rho2 = x * x + y * y, radial = d[0] * rho2 + d[1] * rho2 * rho2;
    const double u = x + x * radial + 2 * d[2] * x * y + d[3] * (rho2 + 2 * x * x);
    const double v = y + y * radial + 2 * d[3] * x * y + d[2] * (rho2 + 2 * y * y);
    return {info.intrinsics[0] * u + info.intrinsics[2], info.intrinsics[4] * v + info.intrinsics[5]};
}

/// A black picture with a soft white spot where each ray of a grid is seen.
class Grid {
public:
    Grid(const CameraInfoSample& info, const Pose& cameraInBase) {
        m_picture.bytes.resize(static_cast<std::size_t>(Side) * Side);
        for (int yaw = -180; yaw < 180; yaw += 15) {
            for (int elevation = -45; elevation <= 10; elevation += 11) {
                const Ray ray{degrees(yaw), degrees(elevation)};
                rays.push_back(ray);
                spot(byThePaper(info, cameraInBase.linear().transpose() * towards(ray.yaw, ray.elevation)));
            }
        }
    }
    [[nodiscard]] const Picture& picture() const { return m_picture; }

    struct Ray {
        double yaw, elevation;
    };
    std::vector<Ray> rays;

private:
    void spot(const Eigen::Vector2d& at) {
        constexpr int Reach = 8;
        for (int y = static_cast<int>(at.y()) - Reach; y <= static_cast<int>(at.y()) + Reach; ++y) {
            for (int x = static_cast<int>(at.x()) - Reach; x <= static_cast<int>(at.x()) + Reach; ++x) {
                if (x < 0 || y < 0 || x >= Side || y >= Side) continue;
                const double bright = 255.0 * std::exp(-(Eigen::Vector2d(x, y) - at).squaredNorm() / 8.0);
                auto& pixel =
                    m_picture.bytes[static_cast<std::size_t>(y) * Side + static_cast<std::size_t>(x)];
                pixel = static_cast<std::byte>(
                    std::max(static_cast<int>(pixel), static_cast<int>(std::lround(bright))));
            }
        }
    }
    Picture m_picture{Side, Side, Picture::Pixel::Grey8, {}};
};

/// The middle of the brightness near @p expected [px, the middle of the first is 0.5]; the picture goes on
/// around its sides.
Eigen::Vector2d foundNear(const Picture& picture, const Eigen::Vector2d& expected) {
    constexpr int Reach = 12;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double weight = 0.0;
    for (int y = static_cast<int>(expected.y()) - Reach; y <= static_cast<int>(expected.y()) + Reach; ++y) {
        for (int x = static_cast<int>(expected.x()) - Reach; x <= static_cast<int>(expected.x()) + Reach;
             ++x) {
            if (y < 0 || y >= picture.height) continue;
            const int around = (x % picture.width + picture.width) % picture.width;
            const auto bright = static_cast<double>(
                picture.bytes[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                              static_cast<std::size_t>(around)]);
            sum += bright * Eigen::Vector2d(x + 0.5, y + 0.5);
            weight += bright;
        }
    }
    return weight > 0.0 ? Eigen::Vector2d(sum / weight) : Eigen::Vector2d(-99, -99);
}

TEST(MeiCamera, ProjectsAsThePaperAndBack) {
    for (const double xi : {0.0, 0.4, 0.95, 1.0, 1.6}) {
        const CameraInfoSample info = mirror(xi);
        const auto camera = MeiCamera::of(info, Side, Side);
        ASSERT_TRUE(camera);
        int seen = 0;
        for (double off = 2.0; off < 120.0; off += 7.0) {
            for (double around = 0.0; around < 360.0; around += 17.0) {
                const Eigen::Vector3d ray(std::sin(degrees(off)) * std::cos(degrees(around)),
                                          std::sin(degrees(off)) * std::sin(degrees(around)),
                                          std::cos(degrees(off)));
                const auto pixel = camera->project(3.0 * ray);
                if (!pixel || (*pixel - Eigen::Vector2d(480, 480)).norm() > 470) continue;
                ++seen;
                EXPECT_LT((*pixel - byThePaper(info, ray)).norm(), 1e-9);
                const auto back = camera->direction(*pixel);
                ASSERT_TRUE(back) << xi << ' ' << off;
                EXPECT_LT((*back - ray).norm(), 1e-6) << xi << ' ' << off;
            }
        }
        EXPECT_GT(seen, 100) << xi;
    }
}

TEST(MeiCamera, TakesNothingElseForItself) {
    CameraInfoSample pinhole = mirror();
    pinhole.distortionModel = "plumb_bob";
    EXPECT_FALSE(MeiCamera::of(pinhole, Side, Side));
    CameraInfoSample unsaid = mirror();
    unsaid.distortion.pop_back();
    EXPECT_FALSE(MeiCamera::of(unsaid, Side, Side));
    CameraInfoSample uncalibrated = mirror();
    uncalibrated.intrinsics = {};
    EXPECT_FALSE(MeiCamera::of(uncalibrated, Side, Side));
    CameraInfoSample nonsense = mirror();
    nonsense.distortion[4] = NAN;
    EXPECT_FALSE(MeiCamera::of(nonsense, Side, Side));
    EXPECT_FALSE(MeiCamera::of(mirror(), 0, Side));
    const auto camera = MeiCamera::of(mirror(), Side, Side);
    ASSERT_TRUE(camera);
    EXPECT_FALSE(camera->project({0, 0, -1}));
    EXPECT_FALSE(camera->project({0, 0, 0}));
    EXPECT_FALSE(camera->direction({1e6, 1e6}));
}

TEST(MeiCamera, KnowsReducedPictures) {
    const auto whole = MeiCamera::of(mirror(), Side, Side),
               half = MeiCamera::of(mirror(), Side / 2, Side / 2);
    ASSERT_TRUE(whole && half);
    const Eigen::Vector2d large = *whole->project({0.5, -0.3, 0.2}), small = *half->project({0.5, -0.3, 0.2});
    EXPECT_LT(((large.array() + 0.5) / 2.0 - 0.5 - small.array()).matrix().norm(), 1e-9);
}

TEST(Panorama, ShowsKnownRaysWithinAPixel) {
    for (const double turned : {0.0, degrees(37)}) {
        const Grid grid(mirror(), lookingDown(turned));
        const auto panorama = Panorama::of(mirror(), Side, Side, lookingDown(turned));
        ASSERT_TRUE(panorama);
        const PanoramaShape& shape = panorama->shape();
        EXPECT_EQ(shape.width % 4, 0);
        EXPECT_NEAR(shape.width, 2.0 * std::numbers::pi * 330 / 0.95, 120) << "as fine as the horizon";
        const Picture made = panorama->unwrapped(grid.picture());
        ASSERT_EQ(made.width, shape.width);
        ASSERT_EQ(made.height, shape.height);
        double worst = 0.0;
        for (const Grid::Ray& ray : grid.rays) {
            const Eigen::Vector2d expected(shape.columnOf(ray.yaw), shape.rowOf(ray.elevation));
            const double miss = (foundNear(made, expected) - expected).norm();
            EXPECT_LT(miss, 1.0) << inDegrees(ray.yaw) << ", " << inDegrees(ray.elevation);
            worst = std::max(worst, miss);
        }
        std::printf("%zu rays, at worst %.2f px off in %d x %d\n", grid.rays.size(), worst, made.width,
                    made.height);
    }
}

TEST(Panorama, HasAheadInTheMiddleAndLeftOnTheLeft) {
    const PanoramaShape shape{720, 150};
    EXPECT_NEAR(shape.columnOf(0.0), 360.0, 1e-9);
    EXPECT_NEAR(shape.columnOf(degrees(90)), 180.0, 1e-9);
    EXPECT_NEAR(shape.columnOf(degrees(-90)), 540.0, 1e-9);
    EXPECT_NEAR(shape.columnOf(degrees(-90 + 720)), 540.0, 1e-9);
    EXPECT_NEAR(inDegrees(shape.yawAt(0.0)), 180.0, 1e-9);
    EXPECT_NEAR(shape.rowOf(shape.highest), 0.0, 1e-9);
    EXPECT_NEAR(shape.rowOf(shape.lowest), 150.0, 1e-9);
    EXPECT_NEAR(shape.elevationAt(shape.rowOf(degrees(-20))), degrees(-20), 1e-12);
}

TEST(Panorama, IsMadeAnewForOtherPicturesOnly) {
    const auto panorama = Panorama::of(mirror(), Side, Side, lookingDown());
    ASSERT_TRUE(panorama);
    EXPECT_TRUE(panorama->fits(mirror(), Side, Side));
    EXPECT_FALSE(panorama->fits(mirror(), Side / 2, Side / 2));
    EXPECT_FALSE(panorama->fits(mirror(0.9), Side, Side));
    const Picture other{4, 4, Picture::Pixel::Grey8, std::vector<std::byte>(16)};
    EXPECT_EQ(panorama->unwrapped(other).width, 4);
    CameraInfoSample pinhole = mirror();
    pinhole.distortionModel = "plumb_bob";
    EXPECT_FALSE(Panorama::of(pinhole, Side, Side, lookingDown()));
}

TEST(RawOmni, KnowsWhereAheadIs) {
    const auto ahead = rawPlaceOf(mirror(), lookingDown(), 0.0, Side, Side);
    const auto left = rawPlaceOf(mirror(), lookingDown(), degrees(90), Side, Side);
    ASSERT_TRUE(ahead && left);
    EXPECT_NEAR(ahead->x(), 0.5, 0.01);
    EXPECT_LT(ahead->y(), 0.25) << "the top of the picture";
    EXPECT_LT(left->x(), 0.25);
    EXPECT_NEAR(left->y(), 0.5, 0.01);
}

}  // namespace
}  // namespace leitstand
