#include <chrono>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "tests/simulation/world/test_arena.h"

namespace leitstand::simulation {
namespace {

class BothRobots : public testing::TestWithParam<BodySpec> {};

INSTANTIATE_TEST_SUITE_P(World, BothRobots, testing::Values(kurt3dBody(), crawlerBody()),
                         [](const auto& info) { return info.param.name; });

TEST_P(BothRobots, StandStillOnTheFloor) {
    World world = TestArena().world();
    const int robot = world.addRobot(GetParam(), poseFrom({1, 2, 0}, 0, 0, 0.5));
    const Pose before = world.state(robot).baseInArena;
    EXPECT_NEAR(before.translation().z(), 0.0, 1e-5);
    EXPECT_NEAR(yawOf(world.state(robot)), 0.5, 1e-9);
    world.advance(std::chrono::seconds(5));
    EXPECT_TRUE(world.state(robot).baseInArena.isApprox(before, 1e-6));
    EXPECT_FALSE(world.state(robot).tipped);
    EXPECT_FALSE(world.state(robot).blocked);
    EXPECT_TRUE(world.bumps().empty());
}

/// The share of the encoders' way that is missing at the ground: mean 3 %, deviation 2 % each half second.
TEST_P(BothRobots, SlipAsTheirSpecSays) {
    TestArena arena;
    addBox(arena.mesh.still, 0, {-20, -20, -0.1}, {200, 20, 0});
    double sum = 0.0, squares = 0.0;
    int count = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        World world = arena.world(seed);
        const int robot = world.addRobot(GetParam(), Pose::Identity());
        Driver driver(world, robot);
        driver.drive(0.4, 0.4, 1.0);
        for (int i = 0; i < 60; ++i) {
            const BodyState before = world.state(robot);
            driver.drive(0.4, 0.4, 0.5);
            const BodyState& after = world.state(robot);
            const double encoders = 0.5 * (after.travelledLeft + after.travelledRight - before.travelledLeft -
                                           before.travelledRight);
            const double way = (after.baseInArena.translation() - before.baseInArena.translation()).norm();
            const double slip = 1.0 - way / encoders;
            sum += slip;
            squares += slip * slip;
            ++count;
        }
    }
    const double mean = sum / count, deviation = std::sqrt(squares / count - mean * mean);
    std::printf("slip of %s: mean %.4f, deviation of both sides' mean %.4f\n", GetParam().name.c_str(), mean,
                deviation);
    EXPECT_NEAR(mean, 0.03, 0.004);
    EXPECT_NEAR(deviation, 0.02 / std::sqrt(2.0), 0.004);
}

TEST_P(BothRobots, TurnOnTheSpotSlowerThanTheirWheelsSay) {
    World world = TestArena().world(3);
    const int robot = world.addRobot(GetParam(), Pose::Identity());
    Driver driver(world, robot);
    double turned = 0.0, last = 0.0;
    for (int i = 0; i < 100; ++i) {
        driver.drive(-0.15, 0.15, 0.1);
        const double yaw = yawOf(world.state(robot));
        turned += std::remainder(yaw - last, 2.0 * 3.14159265358979);
        last = yaw;
    }
    const double wheels =
        (world.state(robot).travelledRight - world.state(robot).travelledLeft) / GetParam().trackWidth;
    EXPECT_NEAR(turned / wheels, (1.0 - GetParam().slip.turning) * 0.97, 0.03);
    EXPECT_LT(world.state(robot).baseInArena.translation().head<2>().norm(), 0.1);
    EXPECT_NEAR(world.state(robot).angular.z(), turned / 10.0, 0.25 * turned / 10.0);
}

TEST_P(BothRobots, ReachTheirTopSpeedAndStop) {
    World world = TestArena().world();
    const int robot = world.addRobot(GetParam(), Pose::Identity());
    world.setMotors(robot, 1.0, 1.0);
    world.advance(std::chrono::seconds(2));
    EXPECT_NEAR(world.state(robot).linear.x(), 0.6, 0.06);
    EXPECT_NEAR(world.state(robot).leftCurrent / GetParam().motor.stallCurrent,
                GetParam().motor.friction / GetParam().motor.stallForce, 0.05);
    world.setMotors(robot, 0.0, 0.0);
    world.setBrake(robot, true);
    world.advance(std::chrono::milliseconds(300));
    EXPECT_EQ(world.state(robot).linear.x(), 0.0);
    EXPECT_EQ(world.state(robot).left, 0.0);
}

TEST(World, IsTheSameForTheSameSeed) {
    const auto drive = [](std::uint64_t seed) {
        TestArena arena;
        arena.box({2, -1, 0}, {2.1, 1, 0.5});
        arena.ramp({-1, 3, 0}, degrees(12), 2);
        World world = arena.world(seed);
        const int kurt = world.addRobot(kurt3dBody(), poseFrom({0, 0, 0}, 0, 0, 0.3));
        const int crawler = world.addRobot(crawlerBody(), poseFrom({-2, 3, 0}, 0, 0, 0));
        std::vector<double> numbers;
        for (int i = 0; i < 400; ++i) {
            world.setMotors(kurt, 0.6 * std::sin(0.02 * i), 0.5);
            world.setMotors(crawler, 0.5, 0.45);
            world.advance(std::chrono::milliseconds(20));
            for (const int robot : {kurt, crawler}) {
                const auto& matrix = world.state(robot).baseInArena.matrix();
                numbers.insert(numbers.end(), matrix.data(), matrix.data() + 16);
            }
        }
        return numbers;
    };
    EXPECT_EQ(drive(5), drive(5));
    EXPECT_NE(drive(5), drive(6));
}

TEST(World, RemembersFiveSecondsOfPoses) {
    World world = TestArena().world();
    const int robot = world.addRobot(crawlerBody(), Pose::Identity());
    Driver driver(world, robot);
    driver.drive(0.2, 0.25, 3.0);
    const Time then = world.now();
    const Pose pose = world.state(robot).baseInArena;
    driver.drive(0.2, 0.25, 4.0);
    EXPECT_TRUE(world.baseInArena(robot, then).isApprox(pose, 1e-12));
    const Pose between = world.baseInArena(robot, then + std::chrono::microseconds(2500));
    const Pose after = world.baseInArena(robot, then + Tick);
    EXPECT_NEAR(distanceBetween(between, pose), 0.5 * distanceBetween(after, pose), 1e-9);
    EXPECT_TRUE(world.baseInArena(robot, world.now() + std::chrono::seconds(1))
                    .isApprox(world.state(robot).baseInArena, 1e-12));
    driver.drive(0.2, 0.25, 4.0);
    EXPECT_FALSE(world.baseInArena(robot, then).isApprox(pose, 1e-3)) << "longer ago than 5 s";
}

TEST(World, StartsRobotsWhereTheArenaSays) {
    TestArena arena;
    arena.arena.starts["crawler"] = poseFrom({3, 1, 0.2}, 0, 0, 1.0);
    World world = arena.world();
    const int robot = world.addRobot(crawlerBody());
    const Pose& pose = world.state(robot).baseInArena;
    EXPECT_TRUE(pose.translation().isApprox(Eigen::Vector3d(3, 1, 0), 1e-5)) << "let down to the floor";
    EXPECT_NEAR(yawOf(world.state(robot)), 1.0, 1e-9);
    EXPECT_THROW(world.addRobot(kurt3dBody()), std::invalid_argument);
    EXPECT_EQ(world.robotCount(), 1);
}

/// Of one core, for two robots that drive in a maze of 200 walls.
TEST(WorldLatency, TwoRobotsTakeLessThanATenthOfACore) {
    TestArena arena;
    for (int i = 0; i < 200; ++i) {
        const double x = 1.2 * (i % 14) - 8.0, y = 1.2 * (i / 14) - 8.0;
        arena.box({x, y, 0}, {x + 0.05, y + 0.9, 1.2});
    }
    World world = arena.world();
    const int kurt = world.addRobot(kurt3dBody(), poseFrom({-0.5, -0.6, 0}, 0, 0, 1.57));
    const int crawler = world.addRobot(crawlerBody(), poseFrom({1.9, -0.6, 0}, 0, 0, 1.57));
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < 1'000; ++i) {
        const double turn = 0.4 * std::sin(0.01 * i);
        world.setMotors(kurt, 0.4 - turn, 0.4 + turn);
        world.setMotors(crawler, 0.4 + turn, 0.4 - turn);
        world.advance(std::chrono::milliseconds(20));
    }
    const double share =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / 20.0;
    std::printf("two robots take %.1f %% of a core\n", 100.0 * share);
    EXPECT_LT(share, 0.3) << "on a busy machine; 0.1 on a quiet one";
}

}  // namespace
}  // namespace leitstand::simulation
