#include "core/mapping/placement/placement.h"

#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/mapping/placement/laser_localiser.h"
#include "core/mapping/placement/wall_fit.h"
#include "tests/core/mapping/live/slices.h"
#include "tests/core/mapping/placement/flat_world.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

const Pose There = FlatWorld::at(0.1, -0.4, degrees(20));

double off(const Pose& a, const Pose& b) {
    return (a.translation() - b.translation()).head<2>().norm();
}

TEST(Placement, ARobotIsFoundFromASlotThatIsWrong) {
    const FlatWorld world = FlatWorld::nook();
    const LocalMap map = world.map();
    for (const double turn : {-25.0, -15.0, 0.0, 15.0, 25.0}) {
        const Pose guess = There * poseFrom({0.3, -0.3, 0}, 0, 0, degrees(turn));
        const Placement found = placeRobot(world.view(There), map, guess, SearchWindow{});
        EXPECT_TRUE(found.certain) << found.how;
        EXPECT_LT(off(found.baseInMap, There), 0.03) << turn;
        EXPECT_LT(inDegrees(angleBetween(found.baseInMap, There)), 1.0) << turn;
        EXPECT_GT(found.overlap, 0.9);
        EXPECT_NEAR(found.baseInMap.translation().z(), -0.5, 0.02) << "it stands on the map's floor";
    }
}

TEST(Placement, ACorridorLeavesADirectionOpenAndSoNothingIsCertain) {
    const FlatWorld world = FlatWorld::corridor();
    const Pose there = FlatWorld::at(0, 0.2, 0);
    const Placement found =
        placeRobot(world.view(there), world.map(), FlatWorld::at(0.3, 0, 0.1), SearchWindow{});
    EXPECT_FALSE(found.certain);
    EXPECT_LT(found.certainty, 0.2);
    EXPECT_THAT(found.how, testing::AnyOf(HasSubstr("direction_open"), HasSubstr("elsewhere")));
    EXPECT_LT(off(found.baseInMap, FlatWorld::at(0.3, 0, 0.1)), 1e-9) << "nothing is claimed";
}

TEST(Placement, ARobotThatIsSomewhereElseIsNotFound) {
    const FlatWorld world = FlatWorld::nook();
    const FlatWorld other({{{-3, -3}, {3, -2}}, {{3, -2}, {2.5, 3}}, {{2.5, 3}, {-3, -3}}});
    const Placement found = placeRobot(other.view(There), world.map(), There, SearchWindow{});
    EXPECT_FALSE(found.certain);
    EXPECT_THAT(found.how, HasSubstr("too_little_in_map"));
    EXPECT_FALSE(placeRobot({}, world.map(), There, SearchWindow{}).certain) << "a laser that is dark";
    EXPECT_FALSE(placeRobot(world.view(There), {}, There, SearchWindow{}).certain) << "a map that is empty";
}

TEST(Placement, CorrelationFindsWhatTryingAllPosesFinds) {
    const FlatWorld world = FlatWorld::nook();
    const LaserView view = world.view(There);
    const WallMap map = wallMap(world.map(), There, view.low, view.high);
    const FlatPose guess = FlatPose::of(There * poseFrom({0.2, 0.1, 0}, 0, 0, degrees(7)));
    const Correlation found = correlate(view, map, guess, {0.4, degrees(12)});
    double best = 0.0;  // windows of a few blocks each, all of which are looked at
    for (double x = -0.4; x < 0.41; x += 0.2) {
        for (double y = -0.4; y < 0.41; y += 0.2) {
            const FlatPose pose{guess.place + Eigen::Vector2d(x, y), guess.heading};
            best = std::max(best, correlate(view, map, pose, {0.1, degrees(12)}).score);
        }
    }
    EXPECT_NEAR(found.score, best, 0.02);
    EXPECT_GE(found.score, found.second);
    EXPECT_LT((found.pose.place - There.translation().head<2>()).norm(), 0.08);
}

TEST(LaserView, AQuickTurnAndATiltAreTakenOut) {
    const FlatWorld world = FlatWorld::nook();
    MotionBuffer motion;
    const Time begin(1000s);
    const double turning = 2.0;
    for (int i = -10; i < 20; ++i)
        motion.add(odometryAt(begin + i * 10ms, poseFrom({0, 0, 0}, 0, 0, turning * 0.01 * i)));
    const RangesSample ranges = world.ranges(There, begin, turning);
    const Pose end = There * poseFrom({0, 0, 0}, 0, 0, turning * 0.1);
    const WallFit moved = fitToWalls(laserView(ranges, FlatWorld::laserInBase(), motion),
                                     wallMap(world.map(), end, 0.14, 0.45), FlatPose::of(end), {0.2, 0.1});
    EXPECT_GT(moved.overlap, 0.95);
    EXPECT_LT((moved.pose.place - end.translation().head<2>()).norm(), 0.02);
    EXPECT_LT(inDegrees(std::abs(moved.pose.heading - FlatPose::of(end).heading)), 0.5);

    const Pose tilted = There * poseFrom({0, 0, 0.02}, degrees(3), degrees(-5), 0);
    MotionBuffer level;
    level.add(odometryAt(begin, tilted));
    level.add(odometryAt(begin + 200ms, tilted));
    const LaserView view = laserView(world.ranges(tilted, begin), FlatWorld::laserInBase(), level);
    const Placement found = placeRobot(view, world.map(), There, {0.3, degrees(10)});
    EXPECT_TRUE(found.certain) << found.how;
    EXPECT_LT(off(found.baseInMap, There), 0.05);
    EXPECT_NEAR(inDegrees(std::acos(found.baseInMap.linear()(2, 2))), std::hypot(3.0, 5.0), 0.5);
}

TEST(LaserView, ALaserThatDoesNotTellHowFarItSeesIsTakenAsItIs) {
    const FlatWorld world = FlatWorld::nook();
    RangesSample ranges = world.ranges(There, Time(1000s));
    const std::size_t points = laserView(ranges, FlatWorld::laserInBase(), {}).points.size();
    ranges.rangeMax = ranges.rangeMin = 0.0;
    ranges.ranges.push_back(0.0F);
    ranges.ranges.push_back(std::numeric_limits<float>::quiet_NaN());
    EXPECT_EQ(laserView(ranges, FlatWorld::laserInBase(), {}).points.size(), points);
    EXPECT_GT(points, 20U);
}

/// What a 3D scanner on a robot at @p baseInMap has of @p world: walls and floor with noise, a ceiling, and
/// rays that nothing answered.
LiveScan scanIn(const FlatWorld& world, const Pose& baseInMap) {
    LiveScan live;
    live.sensorInBase = poseFrom({0.1, 0.05, 0.4}, 0, degrees(10), degrees(30));
    const Pose sensorInMap = baseInMap * live.sensorInBase;
    std::mt19937 random(11);
    std::normal_distribution<double> noise(0.0, 0.01);
    auto scan = std::make_shared<Scan>();
    scan->end = Time(1000s);
    const auto add = [&](const Eigen::Vector3d& inMap) {
        const Eigen::Vector3d off(noise(random), noise(random), noise(random));
        scan->points.push_back((sensorInMap.inverse() * Eigen::Vector3d(inMap + off)).cast<float>());
    };
    for (const Eigen::Vector3f& point : world.map().cloud.points) {
        add(point.cast<double>());
        if (point.z() < -0.45F) add(point.cast<double>() + Eigen::Vector3d(0, 0, 1.2));
        scan->points.push_back(Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
    }
    live.scan = scan;
    live.up = sensorInMap.linear().transpose() * Eigen::Vector3d::UnitZ();
    live.levelKnown = true;
    return live;
}

TEST(LaserView, AThreeDimensionalScanPlacesARobotAsItsLaserWould) {
    const FlatWorld world = FlatWorld::nook();
    const Pose tilted = There * poseFrom({0, 0, 0.02}, degrees(3), degrees(-5), 0);
    for (const double turn : {-20.0, 0.0, 20.0}) {
        const Pose guess = There * poseFrom({0.3, -0.25, 0}, 0, 0, degrees(turn));
        const LaserView view = laserView(scanIn(world, tilted));
        const Placement found = placeRobot(view, world.map(), guess, SearchWindow{});
        EXPECT_TRUE(found.certain) << found.how;
        EXPECT_LT(off(found.baseInMap, There), 0.05) << turn;
        EXPECT_NEAR(inDegrees(std::acos(found.baseInMap.linear()(2, 2))), std::hypot(3.0, 5.0), 0.5);
    }
    const FlatWorld corridor = FlatWorld::corridor();
    const Placement open = placeRobot(laserView(scanIn(corridor, FlatWorld::at(0, 0.2, 0))), corridor.map(),
                                      FlatWorld::at(0.3, 0, 0.1), SearchWindow{});
    EXPECT_LT(open.certainty, 0.5) << "between two walls a direction is open";
}

TEST(LaserView, WhatIsOutsideOfWhatBelongsIntoTheMapIsLeftOut) {
    LaserView view;
    view.points = {{1.0F, 0.0F}, {3.0F, 0.0F}, {0.0F, 1.0F}, {0.0F, -1.0F}};
    const auto left = [&](const Pose& baseInMap, const MapCrop& crop) {
        LaserView cropped = view;
        leaveOutCropped(cropped, baseInMap, crop);
        return cropped.points.size();
    };
    MapCrop crop;
    EXPECT_EQ(left(Pose::Identity(), crop), 4U) << "everything belongs into it";
    crop.polygon = {{-2, -2}, {2, -2}, {2, 0.5}, {-2, 0.5}};
    EXPECT_EQ(left(Pose::Identity(), crop), 2U);
    EXPECT_EQ(left(poseFrom({0, 0, 0}, 0, 0, degrees(-90)), crop), 3U) << "in the map, not beside the robot";
    crop.polygon.clear();
    crop.ceiling = 2.0;
    EXPECT_EQ(left(Pose::Identity(), crop), 4U);
    EXPECT_EQ(left(poseFrom({0, 0, 2.5}, 0, 0, 0), crop), 0U) << "on a floor that is left out";
}

/// A robot whose odometry is right but for @ref slip, followed in the nook.
struct Followed {
    FlatWorld world = FlatWorld::nook();
    LocalMap map = world.map();
    LaserLocaliser localiser;
    MotionBuffer motion;
    Time now = Time(1000s);
    Pose odometry = Pose::Identity(), slip = Pose::Identity(), odomInMap = There;

    Followed() {
        drive(0.0);
        localiser.begin({now, There, 0.9, true, "placed"});
    }
    /// Half a second.
    void drive(double way) {
        for (int i = 0; i < 10; ++i) {
            now += 50ms;
            odometry = odometry * poseFrom({way / 10.0, 0, 0}, 0, 0, 0);
            motion.add(odometryAt(now, odometry));
        }
    }
    MapFix follow(const FlatWorld& seen) {
        const Pose truth = There * slip * odometry;
        const MapFix fix = localiser.follow(seen.view(truth, now), map, odomInMap * odometry, motion);
        odomInMap = fix.baseInMap * odometry.inverse();
        return fix;
    }
};

TEST(LaserLocaliser, FollowsSmallErrorsOfTheOdometry) {
    Followed robot;
    for (int i = 0; i < 5; ++i) {
        robot.drive(0.1);
        EXPECT_TRUE(robot.localiser.due(robot.now + 100ms, robot.motion));
        robot.slip = robot.slip * poseFrom({-0.02, 0.01, 0}, 0, 0, degrees(1.5));
        const MapFix fix = robot.follow(robot.world);
        EXPECT_TRUE(fix.certain) << fix.how;
        EXPECT_LT(off(fix.baseInMap, There * robot.slip * robot.odometry), 0.03);
    }
    EXPECT_FALSE(robot.localiser.due(robot.now + 200ms, robot.motion)) << "not so soon";
}

TEST(LaserLocaliser, WhatItDoesNotKnowIsToldAndNothingJumps) {
    Followed robot;
    const FlatWorld unknown({{{-3, -3}, {3, -2}}, {{3, -2}, {2.5, 3}}, {{2.5, 3}, {-3, -3}}});
    double certainty = 1.0;
    for (int i = 0; i < 6; ++i) {
        robot.drive(0.05);
        const MapFix fix = robot.follow(unknown);
        EXPECT_FALSE(fix.certain);
        EXPECT_LT(fix.certainty, certainty);
        EXPECT_FALSE(fix.how.empty());
        EXPECT_LT(off(fix.baseInMap, There * robot.odometry), 0.005) << "odometry and laser carry it on";
        certainty = fix.certainty;
    }
    const MapFix back = robot.follow(robot.world);
    EXPECT_TRUE(back.certain) << back.how;
    EXPECT_LT(off(back.baseInMap, There * robot.odometry), 0.03);
}

TEST(LaserLocaliser, WhereTheMapEndsItsOwnLaserCarriesItOn) {
    Followed robot;
    const FlatWorld unknown({{{-3, -3}, {3, -2}}, {{3, -2}, {2.5, 3}}, {{2.5, 3}, {-3, -3}}});
    robot.follow(unknown);
    MapFix fix;
    for (int i = 0; i < 10; ++i) {
        robot.drive(0.1);
        robot.slip = robot.slip * poseFrom({-0.03, 0.01, 0}, 0, 0, degrees(-1.0));
        fix = robot.follow(unknown);
        EXPECT_FALSE(fix.certain) << "the map does not say so";
    }
    EXPECT_GT(off(There * robot.odometry, There * robot.slip * robot.odometry), 0.2) << "its tracks slip";
    EXPECT_LT(off(fix.baseInMap, There * robot.slip * robot.odometry), 0.04);
}

TEST(LaserLocaliser, ARobotThatWasShovedIsFoundAgainAndThatIsTold) {
    Followed robot;
    robot.slip = poseFrom({0.35, 0.15, 0}, 0, 0, degrees(8));
    int doubted = 0;
    MapFix fix;
    do {
        robot.drive(0.02);
        fix = robot.follow(robot.world);
    } while (!fix.certain && ++doubted < 10);
    EXPECT_GE(doubted, 1) << "not at once";
    EXPECT_TRUE(robot.localiser.foundAgain());
    EXPECT_THAT(fix.how, HasSubstr("found_again"));
    EXPECT_LT(off(fix.baseInMap, There * robot.slip * robot.odometry), 0.05);
}

}  // namespace
}  // namespace leitstand::test
