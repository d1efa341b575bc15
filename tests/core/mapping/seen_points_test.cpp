#include "core/mapping/seen_points.h"

#include <chrono>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/event/cloud_sample.h"
#include "core/mission/finds/placed_cue.h"

namespace leitstand::test {
namespace {

const Time Begin{std::chrono::seconds(1000)};

/// What a scanner at 0.5 m sees of a wall 3 m ahead with something of 0.4 m width 1.5 m ahead at the left.
CloudSample slice() {
    CloudSample cloud;
    cloud.header.stamp = Begin;
    for (int turn = -30; turn <= 30; ++turn) {
        for (int up = -20; up <= 20; ++up) {
            const double left = std::tan(degrees(turn)), high = std::tan(degrees(up));
            const bool near = left * 1.5 > 0.2 && left * 1.5 < 0.6;
            const double away = near ? 1.5 : 3.0;
            cloud.points.emplace_back(static_cast<float>(away), static_cast<float>(away * left),
                                      static_cast<float>(away * high));
        }
    }
    cloud.points.emplace_back(std::numeric_limits<float>::quiet_NaN(), 0.0F, 0.0F);
    return cloud;
}

Pose scanner() {
    return Pose(Eigen::Translation3d(0, 0, 0.5));
}

SeenPoints seen(const Pose& base = Pose::Identity()) {
    SeenPoints points;
    points.add(slice(), scanner(), [&](Time) { return base; });
    return points;
}

TEST(SeenPoints, RaysMeetTheSurfaceThatTheyPointAt) {
    const SeenPoints points = seen();
    const auto wall = points.meet({{0.2, 0, 0.4}, Eigen::Vector3d(1, -0.2, 0).normalized()}, degrees(2));
    ASSERT_TRUE(wall);
    EXPECT_NEAR(wall->range, 2.8 * std::hypot(1.0, 0.2), 0.05);
    EXPECT_LT(wall->scatter, 0.05);
    const auto thing = points.meet({{0.2, 0, 0.4}, Eigen::Vector3d(1.3, 0.4, 0.1).normalized()}, degrees(2));
    ASSERT_TRUE(thing);
    EXPECT_NEAR(thing->range, std::hypot(1.3, 0.4, 0.1), 0.05);
}

TEST(SeenPoints, AreWhereTheRobotWasThen) {
    Pose base(Eigen::Translation3d(5, 2, 0));
    base.rotate(Eigen::AngleAxisd(std::acos(-1.0) / 2, Eigen::Vector3d::UnitZ()));
    const auto hit = seen(base).meet({{5, 2.2, 0.5}, Eigen::Vector3d(0.1, 1, 0).normalized()}, degrees(2));
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->range, 2.8, 0.06);
}

TEST(SeenPoints, NothingWhereNobodyLooked) {
    const SeenPoints points = seen();
    EXPECT_FALSE(points.meet({{0, 0, 0.5}, {-1, 0, 0}}, degrees(2)));
    EXPECT_FALSE(points.meet({{0, 0, 0.5}, {1, -0.2, 0}}, degrees(2), 2.0)) << "too far";
    EXPECT_FALSE(points.meet({{std::nan(""), 0, 0}, {1, 0, 0}}, degrees(2)));
    EXPECT_FALSE(points.meet({{0, 0, 0.5}, {1, 0, 0}}, 0.0));
    EXPECT_FALSE(SeenPoints().meet({{0, 0, 0.5}, {1, 0, 0}}, degrees(2)));
    SeenPoints nowhere;
    nowhere.add(slice(), scanner(), [](Time) { return std::optional<Pose>(); });
    EXPECT_FALSE(nowhere.meet({{0, 0, 0.5}, {1, -0.2, 0}}, degrees(2)));
}

TEST(SeenPoints, OldOnesAndTheRobotsOwnBodyDoNotCount) {
    SeenPoints points;
    const auto here = [](Time) { return std::optional<Pose>(Pose::Identity()); };
    points.add(slice(), scanner(), here);
    CloudSample later = slice();
    later.header.stamp += std::chrono::seconds(6);
    later.points.resize(1);
    points.add(later, scanner(), here);
    EXPECT_FALSE(points.meet({{0, 0, 0.5}, Eigen::Vector3d(1, -0.2, 0)}, degrees(2)));
    SeenPoints own({{{4, 4}, {-4, 4}, {-4, -4}, {4, -4}}, 3.0});
    own.add(slice(), scanner(), here);
    EXPECT_FALSE(own.meet({{0, 0, 0.5}, Eigen::Vector3d(1, -0.2, 0)}, degrees(2)));
}

TEST(SeenPoints, PlaneLasersCountToo) {
    RangesSample turn;
    turn.header.stamp = Begin;
    turn.angleMin = -1.0;
    turn.angleStep = 0.01;
    turn.rangeMax = 4.0;
    turn.ranges.assign(200, 2.0F);
    turn.ranges[100] = std::numeric_limits<float>::infinity();
    SeenPoints points;
    points.add(turn, Pose(Eigen::Translation3d(0, 0, 0.2)), [](Time) { return Pose::Identity(); });
    const auto hit = points.meet({{0, 0, 0.2}, {1, 0, 0}}, degrees(3));
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->range, 2.0, 0.01);
}

TEST(PlacedCue, IsSurerAcrossTheRayThanAlongAScatteredOne) {
    PlacedCue cue;
    placeByRay(cue, {{0, 0, 0.4}, {1, 0, 0}}, {2.0, 0.3, 9}, degrees(3), true);
    EXPECT_NEAR(cue.inMap.x(), 2.0, 1e-9);
    EXPECT_GT(cue.covariance(0, 0), 4.0 * cue.covariance(1, 1));
    EXPECT_NEAR(cue.covariance(0, 1), 0.0, 1e-12);
    PlacedCue doubted;
    placeByRay(doubted, {{0, 0, 0.4}, {1, 0, 0}}, {2.0, 0.3, 9}, degrees(3), false);
    EXPECT_GT(doubted.covariance(1, 1), cue.covariance(1, 1));
}

}  // namespace
}  // namespace leitstand::test
