#include <chrono>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/simulation/world/test_arena.h"

namespace leitstand::simulation {
namespace {

TEST(Bumps, AWallStopsARobotAndCountsOnce) {
    for (const BodySpec& spec : {kurt3dBody(), crawlerBody()}) {
        TestArena arena;
        arena.box({1, -2, 0}, {1.05, 2, 1.2}, ElementKind::Wall, "north wall");
        World world = arena.world();
        const int robot = world.addRobot(spec, Pose::Identity());
        Driver driver(world, robot);
        driver.drive(0.3, 0.3, 6.0);
        const double front = spec.outline[0].x();
        EXPECT_NEAR(world.state(robot).baseInArena.translation().x(), 1.0 - front, 0.01) << spec.name;
        EXPECT_TRUE(world.state(robot).blocked) << spec.name;
        ASSERT_EQ(world.bumps().size(), 1U) << spec.name;
        EXPECT_FALSE(world.bumps()[0].victim);
        EXPECT_EQ(world.bumps()[0].element, "north wall");
        EXPECT_EQ(world.bumps()[0].robot, robot);
        EXPECT_GT(world.bumps()[0].where.x(), 0.15);
        // Backs off, waits, and comes again: a second one.
        driver.drive(-0.2, -0.2, 1.5);
        EXPECT_FALSE(world.state(robot).blocked) << spec.name;
        driver.drive(0.3, 0.3, 3.0);
        EXPECT_EQ(world.bumps().size(), 2U) << spec.name;
        // Backs off for too short a time: still the same contact.
        driver.drive(-0.3, -0.3, 0.3);
        driver.drive(0.3, 0.3, 2.0);
        EXPECT_LE(world.bumps().size(), 3U) << spec.name;
    }
}

TEST(Bumps, SlidesAlongAWallThatItMeetsObliquely) {
    TestArena arena;
    for (int i = 0; i < 10; ++i) {  // boards side by side: one wall
        arena.box({-1.0 + i, 0.5, 0}, {i + 0.0, 0.55, 1.2}, ElementKind::Wall, "board " + std::to_string(i));
    }
    World world = arena.world();
    const int robot = world.addRobot(kurt3dBody(), poseFrom({0, 0, 0}, 0, 0, degrees(25)));
    Driver driver(world, robot);
    driver.drive(0.3, 0.3, 10.0);
    EXPECT_GT(world.state(robot).baseInArena.translation().x(), 1.5);
    EXPECT_LT(world.state(robot).baseInArena.translation().y(), 0.5 - 0.14);
    EXPECT_EQ(world.bumps().size(), 1U);
}

TEST(Bumps, AVictimCountsAsOne) {
    TestArena arena;
    arena.box({0.8, -0.8, 0}, {1.2, 0.8, 0.25}, ElementKind::Victim, "victim 3", Material::Cloth);
    World world = arena.world();
    const int robot = world.addRobot(crawlerBody(), Pose::Identity());
    Driver driver(world, robot);
    driver.drive(0.3, 0.3, 5.0);
    EXPECT_NEAR(world.state(robot).baseInArena.translation().x(), 0.6, 0.01);
    ASSERT_EQ(world.bumps().size(), 1U);
    EXPECT_TRUE(world.bumps()[0].victim);
    EXPECT_EQ(world.bumps()[0].element, "victim 3");
}

TEST(Bumps, AHandOnTheFloorStopsTooThoughAPlankWouldNot) {
    for (const bool victim : {true, false}) {
        TestArena arena;
        arena.box({0.8, -0.5, 0}, {1.0, 0.5, 0.05}, victim ? ElementKind::Victim : ElementKind::Floor, "low",
                  victim ? Material::Skin : Material::Plywood);
        World world = arena.world();
        const int robot = world.addRobot(crawlerBody(), Pose::Identity());
        Driver(world, robot).drive(0.3, 0.3, 7.0);
        EXPECT_EQ(world.bumps().size(), victim ? 1U : 0U);
        EXPECT_EQ(world.state(robot).baseInArena.translation().x() < 0.7, victim);
    }
}

TEST(Bumps, ClothAndPaperGiveWay) {
    TestArena arena;
    arena.box({0.8, -1, 0}, {0.82, 1, 1.5}, ElementKind::Curtain, "curtain", Material::Cloth);
    arena.box({1.4, -1, 0}, {1.5, 1, 0.2}, ElementKind::LoosePaper, "paper", Material::Paper);
    World world = arena.world();
    const int robot = world.addRobot(kurt3dBody(), Pose::Identity());
    Driver(world, robot).drive(0.3, 0.3, 8.0);
    EXPECT_GT(world.state(robot).baseInArena.translation().x(), 2.0);
    EXPECT_TRUE(world.bumps().empty());
}

TEST(Bumps, ThinPolesAndJuttingBoardsStopToo) {
    for (const bool board : {true, false}) {
        TestArena arena;
        if (board) {
            arena.box({1, -1, 0.40}, {1.4, 1, 0.415}, ElementKind::Overhang, "board");
        } else {
            arena.box({1, 0.05, 0}, {1.035, 0.085, 0.7}, ElementKind::Table, "leg");
        }
        World world = arena.world();
        const int robot = world.addRobot(kurt3dBody(), Pose::Identity());
        Driver(world, robot).drive(0.4, 0.4, 5.0);
        EXPECT_LT(world.state(robot).baseInArena.translation().x(), 0.80) << board;
        EXPECT_EQ(world.bumps().size(), 1U) << board;
        // The crawler passes below the board.
        const int crawler = world.addRobot(crawlerBody(), poseFrom({0, -0.8, 0}, 0, 0, 0));
        Driver(world, crawler).drive(0.4, 0.4, 6.0);
        EXPECT_GT(world.state(crawler).baseInArena.translation().x(), 1.8);
        EXPECT_EQ(world.bumps().size(), 1U) << board;
    }
}

TEST(Bumps, TwoRobotsCollide) {
    World world = TestArena().world();
    const int kurt = world.addRobot(kurt3dBody(), poseFrom({0, 0, 0}, 0, 0, 0));
    const int crawler = world.addRobot(crawlerBody(), poseFrom({1.5, 0, 0}, 0, 0, degrees(180)));
    Driver one(world, kurt), other(world, crawler);
    for (int i = 0; i < 1'000; ++i) {
        one.tick(0.3, 0.3);
        other.tick(0.2, 0.2);
        world.advance(Tick);
    }
    const double distance = distanceBetween(world.state(kurt).baseInArena, world.state(crawler).baseInArena);
    EXPECT_GT(distance, 0.39);
    EXPECT_LT(distance, 0.46);
    ASSERT_EQ(world.bumps().size(), 2U) << "each of them once";
    EXPECT_NE(world.bumps()[0].robot, world.bumps()[1].robot);
    for (const Bump& bump : world.bumps()) EXPECT_EQ(bump.element, bump.robot == kurt ? "crawler" : "kurt3d");
}

TEST(Bumps, GhostsStopRobotsWhereTheyArePlaced) {
    World world = TestArena().world();
    const int robot = world.addRobot(crawlerBody(), Pose::Identity());
    const int ghost = world.addGhost(kurt3dBody());
    Driver driver(world, robot);
    driver.drive(0.3, 0.3, 1.0);
    EXPECT_TRUE(world.bumps().empty()) << "not placed yet";
    world.placeGhost(ghost, poseFrom({1.2, 0, 0}, 0, 0, degrees(90)));
    EXPECT_TRUE(world.baseInArena(ghost, world.now()).isApprox(poseFrom({1.2, 0, 0}, 0, 0, degrees(90))));
    driver.drive(0.3, 0.3, 4.0);
    EXPECT_LT(world.state(robot).baseInArena.translation().x(), 1.2 - 0.16 - 0.18);
    EXPECT_EQ(world.bumps().size(), 1U);
}

}  // namespace
}  // namespace leitstand::simulation
