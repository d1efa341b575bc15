#include <chrono>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/simulation/world/test_arena.h"

namespace leitstand::simulation {
namespace {

TEST(Terrain, ARampOfFifteenDegreesTiltsBothRobotsByFifteen) {
    for (const BodySpec& spec : {kurt3dBody(), crawlerBody()}) {
        TestArena arena;
        arena.ramp({1, 0, 0}, degrees(15), 4);
        World world = arena.world();
        const int robot = world.addRobot(spec, Pose::Identity());
        Driver driver(world, robot);
        driver.drive(0.3, 0.3, 8.0);
        const BodyState& state = world.state(robot);
        EXPECT_NEAR(inDegrees(pitchOf(state)), -15.0, 0.3) << spec.name;
        EXPECT_NEAR(inDegrees(rollOf(state)), 0.0, 0.3) << spec.name;
        const double x = state.baseInArena.translation().x();
        EXPECT_NEAR(state.baseInArena.translation().z(), (x - 1.0) * std::tan(degrees(15)), 0.01)
            << spec.name;
        EXPECT_GT(x, 2.0) << spec.name;
        driver.drive(0.3, 0.3, 14.0);
        EXPECT_NEAR(inDegrees(pitchOf(state)), 0.0, 0.3) << spec.name;
        EXPECT_NEAR(state.baseInArena.translation().z(), 4 * std::tan(degrees(15)), 0.005) << spec.name;
        EXPECT_TRUE(world.bumps().empty()) << spec.name;
    }
}

TEST(Terrain, SlipsMoreUphill) {
    TestArena arena;
    arena.ramp({1, 0, 0}, degrees(15), 12);
    World world = arena.world();
    const int robot = world.addRobot(kurt3dBody(), poseFrom({2, 0, 1}, 0, 0, 0));
    Driver driver(world, robot);
    driver.drive(0.3, 0.3, 2.0);
    const BodyState before = world.state(robot);
    driver.drive(0.3, 0.3, 20.0);
    const BodyState& after = world.state(robot);
    const double way = (after.baseInArena.translation() - before.baseInArena.translation()).norm();
    const double slip = 1.0 - way / (after.travelledLeft - before.travelledLeft);
    EXPECT_NEAR(slip, 0.03 + 0.10 * std::tan(degrees(15)), 0.012);
}

TEST(Terrain, TheCrawlerClimbsStairsOfTenCentimetres) {
    TestArena arena;
    arena.stairs(0.6, 0.10, 0.25, 5);
    World world = arena.world();
    const int robot = world.addRobot(crawlerBody(), Pose::Identity());
    Driver driver(world, robot);
    double steepest = 0.0;
    for (int i = 0; i < 100; ++i) {
        driver.drive(0.25, 0.25, 0.15);
        steepest = std::min(steepest, pitchOf(world.state(robot)));
    }
    const BodyState& state = world.state(robot);
    EXPECT_FALSE(state.tipped);
    EXPECT_NEAR(state.baseInArena.translation().z(), 0.5, 0.005);
    EXPECT_LT(inDegrees(steepest), -15.0);
    EXPECT_GT(inDegrees(steepest), -50.0);
    // And down again, backwards.
    driver.drive(-0.25, -0.25, 15.0);
    EXPECT_FALSE(state.tipped);
    EXPECT_NEAR(state.baseInArena.translation().z(), 0.0, 0.005);
}

TEST(Terrain, TheCrawlerDrivesDownStairsForwards) {
    TestArena arena;
    arena.stairs(0.6, 0.10, 0.25, 5);
    World world = arena.world();
    const int robot = world.addRobot(crawlerBody(), poseFrom({2.6, 0, 0.6}, 0, 0, degrees(180)));
    EXPECT_NEAR(world.state(robot).baseInArena.translation().z(), 0.5, 1e-4);
    Driver(world, robot).drive(0.2, 0.2, 18.0);
    EXPECT_FALSE(world.state(robot).tipped);
    EXPECT_NEAR(world.state(robot).baseInArena.translation().z(), 0.0, 0.005);
    EXPECT_LT(world.state(robot).baseInArena.translation().x(), 0.3);
}

TEST(Terrain, Kurt3dIsStoppedByTheFirstOfThem) {
    TestArena arena;
    arena.stairs(0.6, 0.10, 0.25, 5);
    World world = arena.world();
    const int robot = world.addRobot(kurt3dBody(), Pose::Identity());
    Driver driver(world, robot);
    driver.drive(0.3, 0.3, 6.0);
    const BodyState& state = world.state(robot);
    EXPECT_NEAR(state.baseInArena.translation().x(), 0.6 - 0.225, 0.02);
    EXPECT_NEAR(state.baseInArena.translation().z(), 0.0, 0.01);
    EXPECT_TRUE(state.blocked);
    ASSERT_EQ(world.bumps().size(), 1U);
    EXPECT_EQ(world.bumps()[0].element, "stairs");
}

TEST(Terrain, Kurt3dClimbsFourCentimetresAndNotFive) {
    for (const double riser : {0.04, 0.05}) {
        TestArena arena;
        arena.stairs(0.6, riser, 0.6, 2);
        World world = arena.world();
        const int robot = world.addRobot(kurt3dBody(), Pose::Identity());
        Driver(world, robot).drive(0.3, 0.3, 8.0);
        const double height = riser < 0.045 ? 2 * riser : 0.0;
        EXPECT_NEAR(world.state(robot).baseInArena.translation().z(), height, 0.005);
        EXPECT_EQ(world.bumps().size(), riser < 0.045 ? 0U : 1U);
    }
}

TEST(Terrain, TheCrawlerHoldsAndClimbsThirtyDegrees) {
    TestArena arena;
    arena.ramp({1, 0, 0}, degrees(30), 5);
    World world = arena.world();
    const int robot = world.addRobot(crawlerBody(), poseFrom({2, 0, 1.0}, 0, 0, 0));
    EXPECT_NEAR(inDegrees(pitchOf(world.state(robot))), -30.0, 0.1);
    world.setBrake(robot, true);
    const Pose held = world.state(robot).baseInArena;
    world.advance(std::chrono::seconds(10));
    EXPECT_LT(distanceBetween(held, world.state(robot).baseInArena), 1e-4);
    world.setBrake(robot, false);
    Driver driver(world, robot);
    driver.drive(0.2, 0.2, 2.0);
    const double from = world.state(robot).baseInArena.translation().x();
    for (int i = 0; i < 20; ++i) {
        driver.drive(0.2, 0.2, 0.2);
        EXPECT_NEAR(world.state(robot).left, 0.2, 0.02);
    }
    const double way = (world.state(robot).baseInArena.translation().x() - from) / std::cos(degrees(30));
    EXPECT_NEAR(way, 0.2 * 4.0 * 0.912, 0.04);
    driver.drive(0.0, 0.0, 1.0);
    EXPECT_NEAR(world.state(robot).linear.x(), 0.0, 0.01) << "the speed controller holds";
}

TEST(Terrain, WithoutBrakeAndPowerARobotRollsBack) {
    for (const BodySpec& spec : {kurt3dBody(), crawlerBody()}) {
        TestArena arena;
        arena.ramp({0, 0, 0}, degrees(15), 8);
        World world = arena.world();
        const int robot = world.addRobot(spec, poseFrom({4, 0, 1.2}, 0, 0, 0));
        world.setBrake(robot, true);
        world.advance(std::chrono::seconds(2));
        EXPECT_NEAR(world.state(robot).baseInArena.translation().x(), 4.0, 1e-4) << spec.name;
        world.setBrake(robot, false);
        world.advance(std::chrono::seconds(2));
        EXPECT_LT(world.state(robot).baseInArena.translation().x(), 3.95) << spec.name;
        EXPECT_LT(world.state(robot).left, -0.01) << spec.name;
    }
    // Where the gear holds more than the slope pulls, it stays.
    TestArena arena;
    arena.ramp({0, 0, 0}, degrees(3), 8);
    World world = arena.world();
    const int robot = world.addRobot(kurt3dBody(), poseFrom({4, 0, 0.5}, 0, 0, 0));
    world.advance(std::chrono::seconds(3));
    EXPECT_NEAR(world.state(robot).baseInArena.translation().x(), 4.0, 1e-3);
}

TEST(Terrain, ASideSlopeOfFiftyDegreesTipsKurt3d) {
    TestArena arena;
    arena.ramp({0, 0, 0}, degrees(50), 4, 8);
    World world = arena.world();
    const int across = world.addRobot(kurt3dBody(), poseFrom({2, 0, 2.5}, 0, 0, degrees(90)));
    world.setBrake(across, true);
    world.advance(std::chrono::seconds(2));
    EXPECT_TRUE(world.state(across).tipped);
    EXPECT_NEAR(world.state(across).baseInArena.linear()(2, 2), 0.0, 1e-6) << "on its side";
    const Pose lies = world.state(across).baseInArena;
    world.setMotors(across, 1.0, 1.0);
    world.advance(std::chrono::seconds(1));
    EXPECT_TRUE(world.state(across).baseInArena.isApprox(lies, 1e-12)) << "and stays there";
    EXPECT_GT(world.state(across).left, -1.0);
}

TEST(Terrain, ARampOfThirtyDegreesAcrossDoesNotTip) {
    TestArena arena;
    arena.ramp({0, 0, 0}, degrees(30), 4, 8);
    for (const BodySpec& spec : {kurt3dBody(), crawlerBody()}) {
        World world = arena.world();
        const int robot = world.addRobot(spec, poseFrom({2, 0, 1.5}, 0, 0, degrees(90)));
        world.setBrake(robot, true);
        world.advance(std::chrono::seconds(2));
        EXPECT_FALSE(world.state(robot).tipped) << spec.name;
        EXPECT_NEAR(std::abs(inDegrees(rollOf(world.state(robot)))), 30.0, 0.5) << spec.name;
    }
}

TEST(Terrain, FallsDownALedgeAndGoesOn) {
    TestArena arena;
    arena.box({-3, -1, 0}, {1, 1, 0.10}, ElementKind::Floor, "podium");
    World world = arena.world();
    const int robot = world.addRobot(kurt3dBody(), poseFrom({0, 0, 0.2}, 0, 0, 0));
    EXPECT_NEAR(world.state(robot).baseInArena.translation().z(), 0.10, 1e-4);
    Driver(world, robot).drive(0.3, 0.3, 8.0);
    EXPECT_FALSE(world.state(robot).tipped);
    EXPECT_NEAR(world.state(robot).baseInArena.translation().z(), 0.0, 1e-3);
    EXPECT_GT(world.state(robot).baseInArena.translation().x(), 1.5);
}

TEST(Terrain, TumblesOverACliff) {
    TestArena arena;
    arena.box({-3, -1, 0}, {1, 1, 1.0}, ElementKind::Floor, "podium");
    World world = arena.world();
    const int robot = world.addRobot(kurt3dBody(), poseFrom({0, 0, 1.1}, 0, 0, 0));
    Driver(world, robot).drive(0.3, 0.3, 8.0);
    EXPECT_TRUE(world.state(robot).tipped);
}

TEST(Terrain, FallsFreelyUntilItLands) {
    TestArena arena;
    World world = arena.world();
    const int robot = world.addRobot(crawlerBody(), poseFrom({0, 0, 0}, 0, 0, 0));
    EXPECT_NEAR(world.state(robot).baseInArena.translation().z(), 0.0, 1e-5);
    // Outside the arena's floor there is the hall's.
    World outside = arena.world();
    const int far = outside.addRobot(crawlerBody(), poseFrom({50, 0, 0}, 0, 0, 0));
    Driver(outside, far).drive(0.3, 0.3, 2.0);
    EXPECT_NEAR(outside.state(far).baseInArena.translation().z(), 0.0, 1e-6);
}

TEST(Terrain, TheCrawlerCrossesAStepFieldThatStopsKurt3d) {
    TestArena arena;
    const int wood = arena.surface(ElementKind::StepField, "step field");
    for (int i = 0; i < 12; ++i) {
        for (int j = -8; j < 8; ++j) {
            const double height = 0.02 + 0.08 * (((i * 7 + j * 13 + 200) % 5) / 4.0);
            addBox(arena.mesh.still, wood, {1 + 0.15 * i, 0.15 * j, 0},
                   {1.15 + 0.15 * i, 0.15 * j + 0.15, height});
        }
    }
    World world = arena.world();
    const int crawler = world.addRobot(crawlerBody(), poseFrom({0.3, 0.4, 0}, 0, 0, 0));
    const int kurt = world.addRobot(kurt3dBody(), poseFrom({0.3, -0.4, 0}, 0, 0, 0));
    Driver left(world, crawler), right(world, kurt);
    for (int i = 0; i < 4'000; ++i) {
        left.tick(0.3, 0.3);
        right.tick(0.3, 0.3);
        world.advance(Tick);
    }
    EXPECT_FALSE(world.state(crawler).tipped);
    EXPECT_GT(world.state(crawler).baseInArena.translation().x(), 3.0);
    EXPECT_LT(world.state(kurt).baseInArena.translation().x(), 2.5);
}

}  // namespace
}  // namespace leitstand::simulation
