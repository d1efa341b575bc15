#include "core/perception/surroundings/laser_points.h"

#include <chrono>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "core/event/cloud_sample.h"

namespace leitstand {
namespace {

constexpr Time Stamp{std::chrono::seconds(1'000)};

/// Rays to the left, ahead and to the right, 2 m long, 50 ms apart.
RangesSample threeRays() {
    RangesSample turn;
    turn.header.stamp = Stamp;
    turn.angleMin = std::numbers::pi / 2;
    turn.angleStep = -std::numbers::pi / 2;
    turn.timeStep = 0.05;
    turn.rangeMin = 0.1;
    turn.rangeMax = 8.0;
    turn.ranges = {2.0F, 2.0F, 2.0F};
    return turn;
}

/// It drives ahead with 1 m/s.
std::optional<Pose> driving(Time at) {
    return poseFrom({std::chrono::duration<double>(at - Stamp).count(), 0, 0}, 0, 0, 0);
}

TEST(LaserPoints, LieWhereTheRobotMeasuredEachOfThem) {
    const Pose laser = poseFrom({0.3, 0, 0.2}, 0, 0, 0);
    const auto points = laserPoints(threeRays(), laser, driving);
    ASSERT_EQ(points.size(), 3u);
    EXPECT_LT((points[0] - Eigen::Vector3f(0.3F, 2.0F, 0.2F)).norm(), 1e-4F);
    EXPECT_LT((points[1] - Eigen::Vector3f(2.35F, 0.0F, 0.2F)).norm(), 1e-4F);
    EXPECT_LT((points[2] - Eigen::Vector3f(0.4F, -2.0F, 0.2F)).norm(), 1e-4F);
}

TEST(LaserPoints, WithoutAnEchoOrAPlaceThereIsNone) {
    RangesSample turn = threeRays();
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    turn.ranges = {nan, inf, -1.0F, 0.0F, 0.05F, 9.0F, 3.0F};
    EXPECT_EQ(laserPoints(turn, Pose::Identity(), driving).size(), 1u);
    EXPECT_TRUE(laserPoints(turn, Pose::Identity(), [](Time) { return std::nullopt; }).empty());
    turn.angleStep = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(laserPoints(turn, Pose::Identity(), driving).empty());
    turn.ranges.clear();
    EXPECT_TRUE(laserPoints(turn, Pose::Identity(), driving).empty());
}

}  // namespace
}  // namespace leitstand
