#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/base/pose.h"
#include "tests/widgets/live/sample_robot.h"
#include "widgets/models/live/robots/proximity.h"
#include "widgets/models/live/view_geometry.h"

namespace leitstand {
namespace {

constexpr double Pi = std::numbers::pi;
const BodyBox Body{0.225, 0.225, 0.165, 0.165};

/// All around was looked at now, with one obstacle.
VirtualScanView around(const Eigen::Vector2d& obstacle, double age = 0.0) {
    VirtualScanView view;
    view.sectors.resize(180);
    for (VirtualSector& sector : view.sectors) sector.age = age;
    view.obstacles.push_back({obstacle, age});
    return view;
}

TEST(ProximityRing, MeasuresFromTheBodysEdge) {
    EXPECT_DOUBLE_EQ(distanceFrom(Body, {1.225, 0.1}), 1.0);
    EXPECT_DOUBLE_EQ(distanceFrom(Body, {0.0, -0.465}), 0.3);
    EXPECT_DOUBLE_EQ(distanceFrom(Body, {0.525, 0.565}), 0.5);
    EXPECT_DOUBLE_EQ(distanceFrom(Body, {0.1, 0.1}), 0.0);
}

TEST(ProximityRing, PutsObstaclesWhereTheyAre) {
    for (int part = 0; part < 8; ++part) {
        for (const double aside : {-0.35, 0.0, 0.35}) {
            const double direction = part * Pi / 4 + aside;
            const auto ring =
                proximityRing(around({2 * std::cos(direction), 2 * std::sin(direction)}), Body, {});
            ASSERT_EQ(ring.size(), 8u);
            ASSERT_NE(nearestOf(ring), nullptr);
            EXPECT_EQ(nearestOf(ring), &ring[static_cast<std::size_t>(part)]) << direction;
            EXPECT_LE(ring[static_cast<std::size_t>(part)].from, part * Pi / 4);
        }
    }
}

TEST(ProximityRing, IsLouderWhereTheRobotMovesTo) {
    const VirtualScanView ahead = around({0.225 + 0.6, 0.0});
    EXPECT_EQ(proximityRing(ahead, Body, {})[0].nearness, Nearness::Far);
    EXPECT_EQ(proximityRing(ahead, Body, {0.4, 0, 0})[0].nearness, Nearness::Near);
    EXPECT_EQ(proximityRing(ahead, Body, {-0.4, 0, 0})[0].nearness, Nearness::Far);
    EXPECT_EQ(proximityRing(around({0.225 + 0.29, 0}), Body, {})[0].nearness, Nearness::Near);
    EXPECT_EQ(proximityRing(around({0.225 + 0.1, 0}), Body, {})[0].nearness, Nearness::Touching);
}

TEST(ProximityRing, CallsNothingFreeThatWasNotLookedAt) {
    VirtualScanView view = around({2, 0}, 20.0);
    for (const Proximity& part : proximityRing(view, Body, {})) {
        EXPECT_EQ(part.nearness, Nearness::Unknown);
        EXPECT_FALSE(part.where.has_value());
    }
    EXPECT_EQ(nearestOf(proximityRing(view, Body, {})), nullptr);
    EXPECT_EQ(nearestOf(proximityRing(VirtualScanView{}, Body, {})), nullptr);
    view.obstacles[0].age = 1.0;
    EXPECT_EQ(proximityRing(view, Body, {})[0].nearness, Nearness::Far) << "what was seen counts";
}

TEST(PredictedPath, IsTheStripOfTheBodyUntilItTouches) {
    const PredictedPath straight = predictedPath(Body, {0.5, 0, 0}, 2.0);
    EXPECT_TRUE(straight.left.back().isApprox(Eigen::Vector2d(1.225, 0.165), 1e-9));
    EXPECT_TRUE(straight.right.back().isApprox(Eigen::Vector2d(1.225, -0.165), 1e-9));
    const VirtualScanView wall = around({0.825, 0.0});
    const PredictedPath blocked = predictedPath(Body, {0.5, 0, 0}, 2.0, &wall);
    EXPECT_LT(blocked.left.back().x(), 0.83);
    EXPECT_GT(blocked.left.back().x(), 0.75);
    const PredictedPath back = predictedPath(Body, {-0.5, 0, 0}, 1.0);
    EXPECT_NEAR(back.left.back().x(), -0.725, 1e-9);
    // a quarter of a circle to the left, 1 m in radius
    const PredictedPath arc = predictedPath(Body, {0.5, 0, 0.5}, Pi);
    EXPECT_TRUE((0.5 * (arc.left.back() + arc.right.back())).isApprox(Eigen::Vector2d(1.0, 1.225), 1e-9));
    EXPECT_TRUE(predictedPath(Body, {}, 2.0).isEmpty());
    EXPECT_TRUE(predictedPath(Body, {0, 0, 1.0}, 2.0).isEmpty());
}

TEST(OuterContour, IsNoObstacle) {
    const VirtualScanView view = test::corridor();
    for (const double x : {-0.8, 0.0, 1.3, 3.0, 4.4}) {
        EXPECT_FALSE(standsBeforeWall(view, {x, -0.8})) << x;
        EXPECT_TRUE(standsBeforeWall(view, {x, -0.2})) << x;
    }
    EXPECT_TRUE(standsBeforeWall(VirtualScanView{}, {1, 0}));
}

TEST(HorizonLine, GoesTheOtherWayThanTheCamera) {
    const Horizon level = horizonOf(0, 0, 0, 0);
    EXPECT_NEAR(level.offset, 0.0, 1e-12);
    EXPECT_NEAR(level.slope, 0.0, 1e-12);
    EXPECT_NEAR(horizonOf(0, degrees(10), 0, 0).offset, -std::tan(degrees(10)), 1e-9) << "nose down: higher";
    EXPECT_NEAR(horizonOf(0, 0, 0, degrees(-20)).offset, std::tan(degrees(20)), 1e-9) << "camera up: lower";
    EXPECT_NEAR(horizonOf(0, degrees(10), 0, degrees(-10)).offset, 0.0, 1e-9);
    EXPECT_NEAR(horizonOf(degrees(15), 0, 0, 0).slope, -std::tan(degrees(15)), 1e-9)
        << "right down: right end up";
    // Looking to the left of a robot that rolls to the right, the camera looks up.
    EXPECT_NEAR(horizonOf(degrees(15), 0, degrees(90), 0).offset, std::tan(degrees(15)), 1e-9);
    EXPECT_FALSE(horizonOf(0, 0, 0, degrees(90)).visible);
    EXPECT_FALSE(horizonOf(std::nan(""), 0, 0, 0).visible);
}

}  // namespace
}  // namespace leitstand
