#include <cmath>

#include <gtest/gtest.h>

#include "core/event/cloud_sample.h"
#include "core/perception/surroundings/near_obstacles.h"
#include "core/perception/surroundings/own_body_mask.h"
#include "tests/core/perception/virtual_world.h"

namespace leitstand::test {
namespace {

VirtualScanSettings settings() {
    VirtualScanSettings settings;
    settings.body = {0.25, 0.25, 0.22, 0.22};
    return settings;
}

/// Walls at 4 m all around.
std::vector<Block> room() {
    return {{{4, -4, 0}, {4.1, 4, 2}},
            {{-4.1, -4, 0}, {-4, 4, 2}},
            {{-4, 4, 0}, {4, 4.1, 2}},
            {{-4, -4.1, 0}, {4, -4, 2}}};
}

/// Whether the point there lies on the robot's camera, which is the last block.
bool isCamera(const VirtualWorld& world, const CloudSample& cloud, int row, int column) {
    if (row < 0 || row >= cloud.rows || column < 0 || column >= cloud.columns) return false;
    const Eigen::Vector3f& point = cloud.points[static_cast<std::size_t>(row * cloud.columns + column)];
    if (!point.allFinite()) return false;
    const Eigen::Vector3d at = world.scannerInBase * point.cast<double>();
    const Block& camera = world.blocks.back();
    return ((at - camera.low).array() > -0.05).all() && ((camera.high - at).array() > -0.05).all();
}

/// Beside points on the camera, ranges are mixed with it: in its raw scans and in those @p around it. Returns
/// how many.
int mixEdges(const VirtualWorld& world, CloudSample& cloud, bool around = true) {
    const CloudSample clean = cloud;
    int mixed = 0;
    for (int row = 0; row < cloud.rows; ++row) {
        for (int column = 0; column < cloud.columns; ++column) {
            if (isCamera(world, clean, row, column)) continue;
            const bool edge =
                isCamera(world, clean, row, column - 1) || isCamera(world, clean, row, column + 1) ||
                (around &&
                 (isCamera(world, clean, row - 1, column) || isCamera(world, clean, row + 1, column)));
            Eigen::Vector3f& point = cloud.points[static_cast<std::size_t>(row * cloud.columns + column)];
            if (!edge || !point.allFinite() || point.norm() > 1.5F) continue;
            point = point.normalized() * 0.32F;
            ++mixed;
        }
    }
    return mixed;
}

TEST(VirtualScan, MixedPointsAtTheRobotsOwnEdgesAreNoObstacles) {
    VirtualWorld world;
    world.scannerInBase = poseFrom({0.0, 0.0, 0.5}, 0.0, 0.0, 0.0);
    world.blocks = room();
    world.blocks.push_back({{0.17, -0.05, 0.26}, {0.21, 0.05, 0.33}});  // its camera
    VirtualScan virtualScan(settings());
    std::mt19937 random(3);
    int mixed = 0;
    for (int k = 0; k < 47; ++k) {  // two turns: in the first one it learns where its edges are
        CloudSample slice = world.slice(atSecond(0.1 * k), standing(), random);
        mixed += mixEdges(world, slice);
        virtualScan.add(slice, world.scannerInBase, standing());
    }
    ASSERT_GT(mixed, 10);
    const VirtualScanView view = virtualScan.view(Pose::Identity(), atSecond(4.7));
    EXPECT_NEAR(view.nearest(degrees(-40), degrees(40), 2.4), 4.0, 0.1);
}

TEST(VirtualScan, WhatARawScanMixesWithTheRobotIsNoObstacleInTheFirstTurnEither) {
    VirtualWorld world;
    world.scannerInBase = poseFrom({0.0, 0.0, 0.5}, 0.0, 0.0, 0.0);
    world.blocks = room();
    world.blocks.push_back({{0.17, -0.05, 0.26}, {0.21, 0.05, 0.33}});  // its camera
    VirtualScan virtualScan(settings());
    std::mt19937 random(3);
    int mixed = 0;
    for (int k = 0; k < 24; ++k) {
        CloudSample slice = world.slice(atSecond(0.1 * k), standing(), random);
        mixed += mixEdges(world, slice, false);
        virtualScan.add(slice, world.scannerInBase, standing());
    }
    ASSERT_GT(mixed, 3);
    const VirtualScanView view = virtualScan.view(Pose::Identity(), atSecond(2.4));
    EXPECT_NEAR(view.nearest(degrees(-40), degrees(40), 2.4), 4.0, 0.1);
}

TEST(VirtualScan, ALowThingBesideTheRobotsOwnEdgesIsStillSeen) {
    VirtualWorld world;
    world.scannerInBase = poseFrom({0.0, 0.0, 0.5}, 0.0, 0.0, 0.0);
    world.blocks = room();
    world.blocks.push_back({{0.6, -0.3, 0.0}, {0.7, 0.3, 0.3}});
    world.blocks.push_back({{0.17, -0.05, 0.26}, {0.21, 0.05, 0.33}});
    VirtualScan virtualScan(settings());
    scan(world, virtualScan, standing(), 0.0, 4.7);
    const VirtualScanView view = virtualScan.view(Pose::Identity(), atSecond(4.7));
    for (int direction = -20; direction <= 20; direction += 5)
        EXPECT_NEAR(view.nearest(degrees(direction - 3), degrees(direction + 3), 2.4), 0.6, 0.1) << direction;
}

TEST(OwnBodyMask, ForgetsWhereTheRobotWasMet) {
    OwnBodyMask mask;
    const Eigen::Vector3d ahead(1.0, 0.02, -0.5);
    EXPECT_FALSE(mask.isNear(ahead, atSecond(0.0)));
    mask.add(ahead, atSecond(1.0));
    EXPECT_TRUE(mask.isNear(ahead, atSecond(2.0)));
    EXPECT_TRUE(mask.isNear({1.0, -0.01, -0.5}, atSecond(2.0))) << "beside it";
    EXPECT_FALSE(mask.isNear({1.0, 0.2, -0.5}, atSecond(2.0)));
    EXPECT_FALSE(mask.isNear(ahead, atSecond(30.0))) << "a camera that turned away";
    mask.add({-1.0, 1e-6, 0.0}, atSecond(1.0));
    EXPECT_TRUE(mask.isNear({-1.0, -1e-6, 0.0}, atSecond(1.0))) << "behind, across the seam";
}

TEST(VirtualScan, WhatTheRobotHidesBesideItselfIsNotForgotten) {
    VirtualWorld world;
    world.scannerInBase = poseFrom({0.0, 0.0, 0.5}, 0.0, 0.0, 0.0);
    world.blocks = room();
    world.blocks.push_back({{0.9, 0.1, 0.0}, {1.1, 0.3, 0.09}});        // low, ahead
    world.blocks.push_back({{-0.24, -0.21, 0.2}, {0.24, 0.21, 0.25}});  // the robot's own top: moves along
    VirtualScan virtualScan(settings());
    std::mt19937 random(3);
    Pose base = Pose::Identity();
    const auto standsAt = [&](double x, double from, double to) {
        base = poseFrom({x, 0.0, 0.0}, 0.0, 0.0, 0.0);
        world.blocks.back() = {{x - 0.24, -0.21, 0.2}, {x + 0.24, 0.21, 0.25}};
        for (int k = static_cast<int>(std::lround(10 * from)); k < static_cast<int>(std::lround(10 * to));
             ++k)
            virtualScan.add(world.slice(atSecond(0.1 * k), standing(base), random), world.scannerInBase,
                            standing(base));
    };
    standsAt(0.0, 0.0, 4.6);
    EXPECT_NEAR(virtualScan.view(base, atSecond(4.6)).nearest(0.0, degrees(25)), 0.9, 0.1);
    standsAt(0.55, 4.6, 11.5);  // three turns beside it
    EXPECT_LT(virtualScan.view(base, atSecond(11.5)).nearest(0.0, degrees(45)), 0.55);
    world.blocks[4] = {{90, 90, 0}, {91, 91, 1}};  // taken away
    standsAt(0.55, 11.5, 13.8);
    standsAt(-0.2, 13.8, 18.4);
    EXPECT_GT(virtualScan.view(base, atSecond(18.4)).nearest(0.0, degrees(20)), 3.0) << "looked through";
}

TEST(NearObstacles, StayUntilTheyAreLookedThroughOrOld) {
    NearObstacles near;
    near.add({{1.0, 0.0}, 0.2, atSecond(1.0), {}});
    near.add({{1.01, 0.0}, 0.3, atSecond(2.0), {}});
    ASSERT_EQ(near.all().size(), 1U) << "the same";
    EXPECT_DOUBLE_EQ(near.all()[0].top, 0.3);
    const Eigen::Vector2d here(0.0, 0.0);
    near.lookThrough(here, degrees(30), 0.3, 3.0, atSecond(3.0));
    near.lookThrough(here, degrees(180), 0.3, 3.0, atSecond(3.0));
    near.lookThrough(here, 0.0, 1.2, 3.0, atSecond(3.0));
    near.lookThrough(here, 0.0, 0.3, 0.8, atSecond(3.0));
    EXPECT_EQ(near.all().size(), 1U) << "beside, behind, hidden, not as far";
    near.lookThrough(here, 0.0, 0.3, 3.0, atSecond(3.0));
    EXPECT_TRUE(near.all().empty());
    near.add({{0.4, 0.4}, 0.2, atSecond(4.0), {}});
    near.lookThrough(here, degrees(180), 0.3, 3.0, atSecond(35.0));
    EXPECT_TRUE(near.all().empty());
    OwnBodyMask mask;
    mask.add({0.2, 0.0, -0.15}, atSecond(36.0));
    near.add({{0.3, 0.0}, 0.2, atSecond(36.0), {0.3, 0.0, -0.225}});
    near.add({{0.3, 0.2}, 0.2, atSecond(36.0), {0.3, 0.2, -0.225}});
    near.forgetMixed(mask, 1.0);
    EXPECT_EQ(near.all().size(), 1U) << "one was beside the robot's own edge";
}

TEST(NearObstacles, OfTooManyTheNewestStay) {
    NearObstacles near;
    for (int i = 0; i < 1'200; ++i)
        near.add({{0.05 * (i % 40), 0.05 * (i / 40)}, 0.2, atSecond(0.01 * i), {}});
    EXPECT_EQ(near.all().size(), 1'000U);
    for (const NearObstacles::One& one : near.all()) ASSERT_GE(one.at, atSecond(0.01 * 200));
}

/// A sweep of a scanner whose plane is tilted about y: rows of half a degree, points of 1 degree to the
/// sides.
CloudSample tilted(const VirtualWorld& world, Time start, std::mt19937& random) {
    std::normal_distribution<double> error(0.0, 0.01);
    CloudSample cloud;
    cloud.header = {start, "robot/scanner"};
    cloud.rows = 241;
    cloud.columns = 181;
    for (int row = 0; row < cloud.rows; ++row) {
        const double up = degrees(60.0 - 0.5 * row);
        for (int column = 0; column < cloud.columns; ++column) {
            const double side = degrees(90.0 - column);
            const Eigen::Vector3d direction(std::cos(side) * std::cos(up), std::sin(side),
                                            std::cos(side) * std::sin(up));
            const double range = world.cast(world.scannerInBase.translation(), direction) + error(random);
            cloud.points.push_back(range < 30.0 ? Eigen::Vector3f((range * direction).cast<float>())
                                                : Eigen::Vector3f::Constant(std::nanf("")));
            cloud.times.push_back(row * std::int64_t{13'333'000} + column * std::int64_t{37'000});
        }
    }
    return cloud;
}

TEST(VirtualScan, TheTiltingScannersSweepIsCutByDirection) {
    VirtualWorld world;
    world.scannerInBase = poseFrom({0.0, 0.0, 0.5}, 0.0, 0.0, 0.0);
    world.blocks = room();
    world.blocks.push_back({{1.5, 0.4, 0.0}, {1.7, 0.8, 0.3}});     // a box to the left ahead
    world.blocks.push_back({{2.0, -1.0, 0.4}, {2.5, -0.6, 0.45}});  // a table's top to the right
    VirtualScan virtualScan(settings());
    std::mt19937 random(3);
    virtualScan.add(tilted(world, atSecond(1.0), random), world.scannerInBase, standing());
    const VirtualScanView view = virtualScan.view(Pose::Identity(), atSecond(4.3));
    EXPECT_NEAR(view.nearest(degrees(17), degrees(23)), 1.6, 0.1);
    EXPECT_NEAR(view.nearest(degrees(-25), degrees(-19)), 2.16, 0.15);
    EXPECT_NEAR(view.nearest(degrees(-8), degrees(8)), 4.0, 0.1);
    EXPECT_NEAR(view.nearest(degrees(75), degrees(85)), 4.05, 0.15);
    ASSERT_TRUE(virtualScan.newest());
    EXPECT_LT(atSecond(4.3) - *virtualScan.newest(), std::chrono::milliseconds(200)) << "as of its end";
    int seen = 0;
    for (const VirtualSector& sector : view.sectors) seen += sector.age < 3.5 ? 1 : 0;
    EXPECT_NEAR(seen, 90, 6) << "half of all directions";
}

}  // namespace
}  // namespace leitstand::test
