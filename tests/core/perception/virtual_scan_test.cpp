#include "core/perception/surroundings/virtual_scan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/cloud_sample.h"
#include "tests/core/perception/virtual_world.h"

namespace leitstand::test {
namespace {

constexpr double Turn = 2.3;

/// A hall of 10 m by 8 m with walls of 2 m.
std::vector<Block> hall() {
    return {{{5, -4, 0}, {5.1, 4, 2}},
            {{-5.1, -4, 0}, {-5, 4, 2}},
            {{-5, 4, 0}, {5, 4.1, 2}},
            {{-5, -4.1, 0}, {5, -4, 2}}};
}

VirtualScanSettings settings() {
    VirtualScanSettings settings;
    settings.body = {0.25, 0.25, 0.22, 0.22};
    return settings;
}

/// What the scan of a whole turn, standing at @p pose, shows then.
VirtualScanView look(const VirtualWorld& world, const Pose& pose = Pose::Identity()) {
    VirtualScan virtualScan(settings());
    scan(world, virtualScan, standing(pose), 0.0, 2.4);
    return virtualScan.view(pose, atSecond(2.4));
}

double innerAhead(const VirtualScanView& view) {
    return view.nearest(degrees(-6), degrees(6));
}

double outerAhead(const VirtualScanView& view) {
    const auto& sector = view.sectors[static_cast<std::size_t>(view.sectorOf(0.01))];
    return sector.outer ? sector.outer->norm() : -1.0;
}

TEST(VirtualScan, SeesTheWallsOfAHallAllAround) {
    VirtualWorld world;
    world.blocks = hall();
    const VirtualScanView view = look(world);
    int walls = 0;
    for (std::size_t i = 0; i < view.sectors.size(); ++i) {
        const auto& sector = view.sectors[i];
        EXPECT_LT(sector.age, 2.5) << i;
        if (!sector.outer || !sector.inner) continue;
        const double offX = std::abs(std::abs(sector.outer->x()) - 5.0);
        const double offY = std::abs(std::abs(sector.outer->y()) - 4.0);
        if (std::min(offX, offY) < 0.15) ++walls;
        EXPECT_NEAR(sector.inner->norm(), sector.outer->norm(), 0.3) << i;
    }
    EXPECT_GT(walls, 165);
    EXPECT_NEAR(innerAhead(view), 5.0, 0.06);
}

TEST(VirtualScan, TheEdgeOfATableIsAnObstacleAlthoughTheFloorBelowIsFree) {
    VirtualWorld world;
    world.blocks = hall();
    world.blocks.push_back({{1.5, -0.6, 0.42}, {2.5, 0.6, 0.46}});
    const VirtualScanView view = look(world);
    EXPECT_NEAR(innerAhead(view), 1.5, 0.08);
    EXPECT_NEAR(outerAhead(view), 5.0, 0.15);
}

TEST(VirtualScan, ObstaclesBeginAtTheFloorOrWhereWhatHangsBegins) {
    VirtualWorld world;
    world.blocks = hall();
    world.blocks.push_back({{1.5, -0.6, 0.0}, {1.8, -0.1, 0.25}});
    world.blocks.push_back({{1.5, 0.1, 0.42}, {2.0, 0.6, 0.46}});
    int boxes = 0, shelves = 0;
    for (const VirtualObstacle& one : look(world).obstacles) {
        if (std::abs(one.where.x() - 1.5) > 0.05 || std::abs(one.where.y()) > 0.7) continue;
        const bool shelf = one.where.y() > 0.0;
        EXPECT_NEAR(one.top, shelf ? 0.44 : 0.25, 0.05) << one.where.transpose();
        EXPECT_NEAR(one.bottom, shelf ? 0.44 : 0.07, 0.05) << one.where.transpose();
        ++(shelf ? shelves : boxes);
    }
    EXPECT_GE(boxes, 5);
    EXPECT_GE(shelves, 5);
}

TEST(VirtualScan, ATableThatTheRobotPassesBelowIsNone) {
    VirtualWorld world;
    world.blocks = hall();
    world.blocks.push_back({{1.5, -0.6, 0.85}, {2.5, 0.6, 0.90}});
    EXPECT_NEAR(innerAhead(look(world)), 5.0, 0.06);
}

TEST(VirtualScan, AHalfOpenShutterIsAnObstacle) {
    VirtualWorld world;
    world.blocks = hall();
    world.blocks.push_back({{2.0, -1.0, 0.5}, {2.03, 1.0, 2.0}});
    const VirtualScanView view = look(world);
    EXPECT_NEAR(innerAhead(view), 2.0, 0.06);
    EXPECT_NEAR(outerAhead(view), 5.0, 0.15) << "seen below the shutter";
}

TEST(VirtualScan, ACurtainIsAnObstacle) {
    VirtualWorld world;
    world.blocks = hall();
    world.blocks.push_back({{2.0, -1.0, 0.02}, {2.01, 1.0, 2.0}});
    EXPECT_NEAR(innerAhead(look(world)), 2.0, 0.06);
}

TEST(VirtualScan, ARampBelowTheClimbingAngleIsFloorASteeperOneIsNot) {
    for (const double angle : {8.0, 15.0, 18.0}) {
        VirtualWorld world;
        world.incline = Incline{1.2, 3.0, 1.8 * std::tan(degrees(angle))};
        EXPECT_GT(innerAhead(look(world)), 10.0) << angle;
    }
    for (const double angle : {26.0, 35.0, 60.0}) {
        VirtualWorld world;
        world.incline = Incline{1.2, 2.2, std::tan(degrees(angle))};
        const double found = innerAhead(look(world));
        EXPECT_GT(found, 1.15) << angle;
        EXPECT_LT(found, 1.9) << angle;
    }
}

TEST(VirtualScan, OnARampTheFloorIsFloorToo) {
    VirtualWorld world;
    world.incline = Incline{-3.0, 3.0, 6.0 * std::tan(degrees(15))};
    const Pose onRamp = poseFrom({0.0, 0.0, 3.0 * std::tan(degrees(15))}, 0.0, degrees(-15), 0.0);
    EXPECT_GT(innerAhead(look(world, onRamp)), 10.0);
    world.blocks.push_back({{1.2, -1.0, 0.0}, {1.3, 1.0, 2.0}});
    EXPECT_NEAR(innerAhead(look(world, onRamp)), 1.2, 0.08);
}

TEST(VirtualScan, StepsCountFromTheHeightThatTheRobotDoesNotClimb) {
    VirtualWorld world;
    world.blocks = hall();
    world.blocks.push_back({{1.5, -1.0, 0.0}, {5.0, 1.0, 0.03}});
    EXPECT_NEAR(innerAhead(look(world)), 5.0, 0.06);
    world.blocks.back().high.z() = 0.12;
    EXPECT_NEAR(innerAhead(look(world)), 1.5, 0.08);
}

TEST(VirtualScan, AHoleInTheFloorIsAnObstacle) {
    VirtualWorld world;
    world.hole = 1.0;
    const double found = innerAhead(look(world));
    EXPECT_GT(found, 0.8);
    EXPECT_LT(found, 1.1);
}

TEST(VirtualScan, StairsDownAreAnObstacleFromTheirEdgeOn) {
    VirtualWorld world;
    world.stairs = StairsDown{1.0, 0.1, 0.25};  // no riser is a hole, all of them are steeper than a ramp
    VirtualScanSettings careful = settings();
    careful.profile.climb = degrees(17);
    VirtualScan virtualScan(careful);
    scan(world, virtualScan, standing(), 0.0, 2.4);
    const double found = innerAhead(virtualScan.view(Pose::Identity(), atSecond(2.4)));
    EXPECT_GT(found, 0.8);
    EXPECT_LT(found, 1.15);
}

TEST(VirtualScan, ARampDownIsFloor) {
    VirtualWorld world;
    world.blocks = hall();
    world.incline = Incline{1.0, 4.0, -0.8};  // 15 degrees
    VirtualScanSettings careful = settings();
    careful.profile.climb = degrees(17);
    VirtualScan virtualScan(careful);
    scan(world, virtualScan, standing(), 0.0, 2.4);
    EXPECT_GT(innerAhead(virtualScan.view(Pose::Identity(), atSecond(2.4))), 3.5);
}

TEST(VirtualScan, SingleMixedPixelsAreNoObstacles) {
    VirtualWorld world;
    world.blocks = hall();
    VirtualScan virtualScan(settings());
    std::mt19937 random(9);
    for (int k = 0; k < 24; ++k) {
        CloudSample cloud = world.slice(atSecond(0.1 * k), standing(), random);
        for (std::size_t row = 1; row < static_cast<std::size_t>(cloud.rows); row += 3)
            cloud.points[row * 161 + 72] *= 0.5F;  // somewhere in the air
        virtualScan.add(cloud, world.scannerInBase, standing());
    }
    const VirtualScanView view = virtualScan.view(Pose::Identity(), atSecond(2.4));
    EXPECT_GT(view.nearest(degrees(-180), degrees(180)), 3.7);
}

TEST(VirtualScan, ARawScanThatIsSentTwiceDoesNotSupportItself) {
    VirtualWorld world;
    world.blocks = hall();
    VirtualScan virtualScan(settings());
    scan(world, virtualScan, standing(), 0.0, 2.3);
    std::mt19937 random(9);
    CloudSample begins = world.slice(atSecond(2.3), standing(), random);
    const auto columns = static_cast<std::size_t>(begins.columns);
    begins.points[72] *= 0.4F;  // somewhere in the air
    CloudSample closes = begins;
    closes.rows = 1;
    closes.points.resize(columns);
    closes.times.resize(columns);
    virtualScan.add(closes, world.scannerInBase, standing());
    virtualScan.add(begins, world.scannerInBase, standing());
    EXPECT_GT(virtualScan.view(Pose::Identity(), atSecond(2.4)).nearest(degrees(-180), degrees(180)), 3.5);
}

TEST(VirtualScan, TheRobotsOwnBodyIsLeftOut) {
    VirtualWorld world;
    world.blocks = hall();
    world.blocks.push_back({{-0.2, -0.2, 0.1}, {0.0, 0.2, 0.4}});
    EXPECT_GT(look(world).nearest(degrees(-180), degrees(180)), 3.7);
}

TEST(VirtualScan, TellsTheAgeOfEachSector) {
    VirtualWorld world;
    world.blocks = hall();
    VirtualScan virtualScan(settings());
    EXPECT_FALSE(virtualScan.newest());
    scan(world, virtualScan, standing(), 0.0, 0.5 * Turn + 0.05);
    const VirtualScanView half = virtualScan.view(Pose::Identity(), atSecond(1.2));
    EXPECT_NEAR(half.oldest(degrees(85), degrees(95)), 1.2 - 0.25 * Turn, 0.12);
    EXPECT_NEAR(half.oldest(degrees(20), degrees(160)), 1.2 - Turn * 20 / 360, 0.12);
    EXPECT_TRUE(std::isinf(half.oldest(degrees(-100), degrees(-80)))) << "not looked at yet";
    EXPECT_TRUE(std::isinf(half.nearest(degrees(-100), degrees(-80))));
    EXPECT_LT(half.nearest(degrees(80), degrees(100)), 4.1);
    EXPECT_TRUE(std::isinf(half.nearest(degrees(80), degrees(100), 0.3))) << "older than asked for";
    const VirtualScanView later = virtualScan.view(Pose::Identity(), atSecond(20.0));
    EXPECT_TRUE(std::isinf(later.oldest(degrees(85), degrees(95)))) << "forgotten";
    EXPECT_TRUE(later.obstacles.empty());
}

TEST(VirtualScan, OdometryMovesItAlong) {
    VirtualWorld world;
    world.blocks = hall();
    // 0.5 m/s ahead while turning left at 20 degrees a second.
    const BaseInOdomAt drive = [](Time at) {
        const double t = std::chrono::duration<double>(at.time_since_epoch()).count(), w = degrees(20);
        return std::optional<Pose>(
            poseFrom({0.5 / w * std::sin(w * t), 0.5 / w * (1 - std::cos(w * t)), 0.0}, 0.0, 0.0, w * t));
    };
    VirtualScan virtualScan(settings());
    scan(world, virtualScan, drive, 0.0, 4.0);
    const Pose now = *drive(atSecond(4.0));
    const VirtualScanView view = virtualScan.view(now, atSecond(4.0));
    int found = 0;
    for (const VirtualObstacle& one : view.obstacles) {
        const Eigen::Vector3d there = now * Eigen::Vector3d(one.where.x(), one.where.y(), 0.0);
        const double off = std::min(std::abs(std::abs(there.x()) - 5.0), std::abs(std::abs(there.y()) - 4.0));
        EXPECT_LT(off, 0.15);
        ++found;
    }
    EXPECT_GT(found, 150);
    EXPECT_LT(view.oldest(degrees(-180), degrees(179)), 3.0) << "no gaps";
}

TEST(VirtualScan, WhatHasGoneIsForgottenWithTheNextTurn) {
    VirtualWorld world;
    world.blocks = hall();
    world.blocks.push_back({{1.5, -0.3, 0.0}, {1.8, 0.3, 1.7}});
    VirtualScan virtualScan(settings());
    scan(world, virtualScan, standing(), 0.0, 2.3);
    EXPECT_NEAR(innerAhead(virtualScan.view(Pose::Identity(), atSecond(2.3))), 1.5, 0.06);
    world.blocks.pop_back();
    scan(world, virtualScan, standing(), 2.3, 4.9);
    EXPECT_NEAR(innerAhead(virtualScan.view(Pose::Identity(), atSecond(4.9))), 5.0, 0.06);
}

TEST(VirtualScan, WithoutOdometryNothingIsAdded) {
    VirtualWorld world;
    world.blocks = hall();
    std::mt19937 random(1);
    const CloudSample slice = world.slice(atSecond(0), standing(), random);
    VirtualScan virtualScan(settings());
    virtualScan.add(slice, world.scannerInBase, [](Time) { return std::optional<Pose>(); });
    EXPECT_FALSE(virtualScan.newest());
    CloudSample nothing = slice;
    for (auto& point : nothing.points) point.setConstant(std::nanf(""));
    virtualScan.add(nothing, world.scannerInBase, standing());
    EXPECT_FALSE(virtualScan.newest());
}

TEST(VirtualScan, UnorganisedCloudsAreCutByDirection) {
    VirtualWorld world;
    world.blocks = hall();
    world.blocks.push_back({{1.5, -0.6, 0.42}, {2.5, 0.6, 0.46}});
    std::mt19937 random(3);
    CloudSample whole;
    for (int k = 0; k < 24; ++k) {
        const CloudSample slice = world.slice(atSecond(0.1 * k), standing(), random);
        whole.points.insert(whole.points.end(), slice.points.begin(), slice.points.end());
    }
    VirtualScan virtualScan(settings());
    virtualScan.add(whole, world.scannerInBase, standing());
    const VirtualScanView view = virtualScan.view(Pose::Identity(), atSecond(0.1));
    EXPECT_NEAR(innerAhead(view), 1.5, 0.08);
    EXPECT_NEAR(view.nearest(degrees(85), degrees(95)), 4.0, 0.08);
}

TEST(VirtualScan, AlsoFromAScannerInAPlane) {
    VirtualWorld world;
    world.blocks = hall();
    world.blocks.push_back({{2.0, -0.5, 0.0}, {2.2, 0.5, 0.5}});
    const Pose mount = poseFrom({0.1, 0.0, 0.2}, 0.0, 0.0, 0.0);
    RangesSample ranges;
    ranges.angleMin = degrees(-120);
    ranges.angleStep = degrees(0.36);
    ranges.rangeMin = 0.02;
    ranges.rangeMax = 5.6;
    for (int i = 0; i < 667; ++i) {
        const double angle = ranges.angleMin + i * ranges.angleStep;
        ranges.ranges.push_back(static_cast<float>(
            world.cast(mount.translation(), Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0))));
    }
    VirtualScan virtualScan(settings());
    virtualScan.add(ranges, mount, standing());
    const VirtualScanView view = virtualScan.view(Pose::Identity(), atSecond(0.1));
    EXPECT_NEAR(innerAhead(view), 2.0, 0.03);
    EXPECT_NEAR(view.nearest(degrees(80), degrees(100)), 4.0, 0.03);
    EXPECT_LT(view.oldest(degrees(-100), degrees(100)), 0.2) << "no echo is a look, too";
    EXPECT_TRUE(std::isinf(view.oldest(degrees(170), degrees(190)))) << "behind it";
    EXPECT_NEAR(view.freeLength(0.0, 0.5, 4.0), 2.0, 0.03);
    EXPECT_NEAR(view.freeLength(degrees(40), 0.5, 4.0), 4.0, 0.03);

    RangesSample tilted = ranges;  // at the floor, 0.6 m ahead
    std::fill(tilted.ranges.begin(), tilted.ranges.end(), 0.7F);
    virtualScan.clear();
    virtualScan.add(tilted, poseFrom({0.1, 0.0, 0.25}, 0.0, degrees(20), 0.0), standing());
    EXPECT_TRUE(std::isinf(innerAhead(virtualScan.view(Pose::Identity(), atSecond(0.1)))));
}

TEST(VirtualScan, APlaneScannerThatDrivesPastAPostRemembersItBesideTheRobot) {
    VirtualWorld world;
    world.blocks = hall();
    world.blocks.push_back({{1.0, 0.35, 0.0}, {1.1, 0.45, 0.5}});
    const Pose mount = poseFrom({0.14, 0.0, 0.2}, 0.0, 0.0, 0.0);
    VirtualScan virtualScan(settings());
    const auto turnFrom = [&](double x, double seconds) {
        RangesSample ranges;
        ranges.header.stamp = atSecond(seconds);
        ranges.angleMin = degrees(-120);
        ranges.angleStep = degrees(0.36);
        ranges.rangeMin = 0.02;
        ranges.rangeMax = 5.6;
        const Pose base = poseFrom({x, 0.0, 0.0}, 0.0, 0.0, 0.0);
        for (int i = 0; i < 667; ++i) {
            const double angle = ranges.angleMin + i * ranges.angleStep;
            ranges.ranges.push_back(static_cast<float>(world.cast(
                (base * mount).translation(), Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0))));
        }
        virtualScan.add(ranges, mount, [base](Time) { return base; });
    };
    double x = 0.0, seconds = 0.0;
    for (; x < 1.2; x += 0.05, seconds += 0.1) turnFrom(x, seconds);
    const Pose here = poseFrom({x, 0.0, 0.0}, 0.0, 0.0, 0.0);
    const double behind = degrees(115), left = degrees(65);
    EXPECT_NEAR(virtualScan.view(here, atSecond(seconds)).nearest(left, behind + degrees(30)), 0.37, 0.06);
    world.blocks.pop_back();
    for (x = 0.6; x < 0.7; x += 0.05, seconds += 0.1) turnFrom(x, seconds);
    EXPECT_GT(virtualScan.view(here, atSecond(seconds)).nearest(left, behind), 1.0) << "it has gone";
}

TEST(VirtualScanView, EdgesAreBridgedByWhatIsNearer) {
    VirtualScanView view;
    view.sectors.resize(180);
    for (int i = 80; i < 100; ++i) {
        const double direction = view.directionOf(i), away = i < 90 ? 1.0 : 3.0;
        if (i >= 88 && i < 93) continue;
        view.sectors[static_cast<std::size_t>(i)].age = 0.1 * (i < 90 ? 1 : 2);
        view.sectors[static_cast<std::size_t>(i)].outer =
            away * Eigen::Vector2d(std::cos(direction), std::sin(direction));
    }
    view.bridgeEdges(4);
    EXPECT_TRUE(std::isinf(view.sectors[90].age)) << "too wide";
    view.bridgeEdges(6);
    EXPECT_DOUBLE_EQ(view.sectors[90].age, 0.2) << "the older of both";
    ASSERT_TRUE(view.sectors[90].outer);
    EXPECT_NEAR(view.sectors[90].outer->norm(), 1.0, 1e-9);
    EXPECT_TRUE(std::isinf(view.sectors[79].age)) << "nothing on its other side";
}

TEST(VirtualScanView, FreeTravelFollowsTheArcWithTheWholeBody) {
    VirtualScanView view;
    view.sectors.resize(180);
    const BodyBox body{0.3, 0.3, 0.25, 0.25};
    EXPECT_DOUBLE_EQ(view.freeTravel(0.5, 0.0, body, 2.0), 2.0);
    view.obstacles = {{{1.3, 0.1}, 0.0}};
    EXPECT_NEAR(view.freeTravel(0.5, 0.0, body, 2.0), 1.0, 0.04);
    EXPECT_DOUBLE_EQ(view.freeTravel(-0.5, 0.0, body, 2.0), 2.0);
    EXPECT_DOUBLE_EQ(view.freeTravel(0.5, 0.8, body, 1.5), 1.5) << "drives around it";
    view.obstacles = {{{0.0, 0.35}, 0.0}};
    EXPECT_DOUBLE_EQ(view.freeTravel(0.5, 0.0, body, 2.0), 2.0) << "passes beside it";
    EXPECT_LT(view.freeTravel(0.0, 0.5, body, 1.0), 0.9) << "its corner touches while it turns";
    view.obstacles = {{{0.28, 0.0}, 0.0}};
    EXPECT_LT(view.freeTravel(0.2, 0.0, body, 1.0), 0.05);
    EXPECT_DOUBLE_EQ(view.freeTravel(-0.2, 0.0, body, 1.0), 1.0) << "may get away from what it touches";
}

TEST(VirtualScan, SpeedLatency) {
    VirtualWorld world;
    world.blocks = hall();
    std::mt19937 random(1);
    std::vector<CloudSample> slices;
    for (int k = 0; k < 23; ++k) slices.push_back(world.slice(atSecond(0.1 * k), standing(), random));
    VirtualScan virtualScan(settings());
    const auto before = std::chrono::steady_clock::now();
    for (const CloudSample& slice : slices) {
        virtualScan.add(slice, world.scannerInBase, standing());
        EXPECT_FALSE(virtualScan.view(Pose::Identity(), slice.header.stamp).sectors.empty());
    }
    const double each =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count() / 23.0;
    std::printf("a slice and a view: %.2f ms\n", 1e3 * each);
    EXPECT_LT(each, 0.02);
}

}  // namespace
}  // namespace leitstand::test
