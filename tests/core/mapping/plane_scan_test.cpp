#include "core/mapping/plane/plane_scan.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/cloud/labels.h"
#include "core/event/cloud_sample.h"

namespace leitstand {
namespace {

constexpr float NoEcho = std::numeric_limits<float>::quiet_NaN();

/// A turn in a square room, 4 m from wall to wall, from its middle; 720 rays.
RangesSample turnInRoom() {
    RangesSample turn;
    turn.header = {Time(std::chrono::seconds(5)), "laser"};
    turn.angleMin = -std::numbers::pi;
    turn.angleStep = 2.0 * std::numbers::pi / 720.0;
    turn.timeStep = 0.1 / 720.0;
    turn.rangeMin = 0.1;
    turn.rangeMax = 12.0;
    for (int i = 0; i < 720; ++i) {
        const double angle = turn.angleMin + i * turn.angleStep;
        turn.ranges.push_back(
            static_cast<float>(2.0 / std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle)))));
    }
    return turn;
}

Pose upsideDown() {
    return poseFrom({0.1, 0.0, 0.3}, std::numbers::pi, 0.0, 0.0);
}

TEST(PlaneScan, EachEchoIsAPointWithItsTime) {
    const CloudSample cloud = cloudOf(turnInRoom(), Pose::Identity());
    ASSERT_EQ(cloud.points.size(), 720U);
    EXPECT_NEAR(cloud.points[360].x(), 2.0F, 1e-3F);  // ahead
    EXPECT_NEAR(cloud.points[540].y(), 2.0F, 1e-3F);  // to the left
    EXPECT_EQ(cloud.times[360], std::llround(1e9 * 0.05));
    EXPECT_TRUE(isPlaneScan(cloud.points));
}

TEST(PlaneScan, RaysWithoutAnEchoAreLeftOut) {
    RangesSample turn = turnInRoom();
    turn.ranges[0] = NoEcho;
    turn.ranges[1] = std::numeric_limits<float>::infinity();
    turn.ranges[2] = 0.0F;
    turn.ranges[3] = 0.05F;  // nearer than the laser measures
    turn.ranges[4] = 40.0F;  // farther
    turn.ranges[5] = -1.0F;
    EXPECT_EQ(cloudOf(turn, Pose::Identity()).points.size(), 714U);
    turn.ranges.assign(720, NoEcho);
    const CloudSample blind = cloudOf(turn, Pose::Identity());
    EXPECT_TRUE(blind.points.empty());
    EXPECT_FALSE(isPlaneScan(blind.points));
    EXPECT_EQ(wallsAndFloor(blind.points, 0.06).size(), 0U);
}

TEST(PlaneScan, ARayThatHitsAnEdgeIsNoEchoBetweenTheSurfaces) {
    RangesSample turn = turnInRoom();
    turn.ranges[360] = 2.0F;
    turn.ranges[361] = 3.0F;  // half on a pillar, half on a wall behind
    turn.ranges[362] = 4.0F;
    EXPECT_EQ(cloudOf(turn, Pose::Identity()).points.size(), 719U);
    turn.ranges[361] = 1.0F;  // a leg of a table is one
    EXPECT_EQ(cloudOf(turn, Pose::Identity()).points.size(), 720U);
}

TEST(PlaneScan, ALaserThatHangsUpsideDownIsMappedUpright) {
    const Pose laser = upsideDown();
    const Pose upright = uprightLaser(laser);
    EXPECT_NEAR(upright.linear()(2, 2), 1.0, 1e-12);
    RangesSample turn = turnInRoom();
    for (int i = 0; i < 720; ++i)
        turn.ranges[static_cast<std::size_t>(i)] = 1.0F + static_cast<float>(i) / 720.0F;
    const CloudSample cloud = cloudOf(turn, laser), asHung = cloudOf(turn, Pose::Identity());
    ASSERT_EQ(cloud.points.size(), asHung.points.size());
    for (std::size_t i = 0; i < cloud.points.size(); i += 50) {
        const Eigen::Vector3d there = laser * asHung.points[i].cast<double>();
        EXPECT_LT((upright * cloud.points[i].cast<double>() - there).norm(), 1e-6);
    }
}

TEST(PlaneScan, TimesThatCannotBeRightAreNotUsed) {
    for (const double step : {0.0, -1.0, 1e9, double{NoEcho}}) {
        RangesSample turn = turnInRoom();
        turn.timeStep = step;
        const CloudSample cloud = cloudOf(turn, Pose::Identity());
        EXPECT_TRUE(cloud.times.empty()) << step;
        EXPECT_EQ(cloud.points.size(), 720U) << step;
    }
}

TEST(PlaneScan, HostileFiguresMakeNoPoints) {
    RangesSample turn = turnInRoom();
    turn.angleStep = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3f& point : cloudOf(turn, Pose::Identity()).points)
        EXPECT_TRUE(point.allFinite());
    turn.angleStep = double{NoEcho};
    EXPECT_TRUE(cloudOf(turn, Pose::Identity()).points.empty());
}

TEST(PlaneScan, WallsStandUprightOnALevelFloor) {
    const PointCloud cloud = wallsAndFloor(cloudOf(turnInRoom(), Pose::Identity()).points, 0.06);
    ASSERT_GT(cloud.size(), 300U);
    int walls = 0, floor = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const Eigen::Vector3f& point = cloud.points[i];
        const Eigen::Vector3f& normal = cloud.normals[i];
        if (point.z() == 0.0F) {
            ++floor;
            EXPECT_EQ(normal, Eigen::Vector3f::UnitZ());
        } else if (std::min(std::abs(point.x()), std::abs(point.y())) < 1.7F) {  // not in a corner
            ++walls;
            EXPECT_EQ(normal.z(), 0.0F);
            EXPECT_LT(normal.dot(point), -1.5F) << "towards the laser";
            EXPECT_NEAR(normal.head<2>().cwiseAbs().maxCoeff(), 1.0F, 0.01F);
        }
    }
    EXPECT_EQ(3 * floor, static_cast<int>(cloud.size()));
    EXPECT_GT(walls, floor);
}

TEST(PlaneScan, NoiseAcrossAWallIsAveraged) {
    RangesSample turn = turnInRoom();
    for (std::size_t i = 0; i < turn.ranges.size(); ++i) turn.ranges[i] += (i % 2 == 0 ? 0.02F : -0.02F);
    double squares = 0.0;
    int count = 0;
    for (const Eigen::Vector3f& point : wallsAndFloor(cloudOf(turn, Pose::Identity()).points, 0.06).points) {
        if (point.z() != 0.0F || std::min(std::abs(point.x()), std::abs(point.y())) > 1.6F) continue;
        const double off = std::max(std::abs(point.x()), std::abs(point.y())) - 2.0;
        squares += off * off;
        ++count;
    }
    EXPECT_LT(std::sqrt(squares / count), 0.005);
}

TEST(PlaneScan, PointsOfOtherScannersAreNone) {
    const std::vector<Eigen::Vector3f> points = {{1.0F, 0.0F, 0.0F}, {1.0F, 1.0F, 0.01F}};
    EXPECT_FALSE(isPlaneScan(points));
    EXPECT_FALSE(isPlaneScan({}));
}

TEST(PlaneScan, ItsPointsAreWalls) {
    Scan scan;
    scan.points = cloudOf(turnInRoom(), Pose::Identity()).points;
    EXPECT_THAT(labelScan(scan), testing::Each(Label::Wall));
}

}  // namespace
}  // namespace leitstand
