#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>

#include <gtest/gtest.h>

#include "tests/simulation/world/test_arena.h"

namespace leitstand::simulation {
namespace {

/// A yard with walls around it and a bit of everything inside.
TestArena yard(std::uint64_t seed) {
    TestArena arena;
    const auto wall = [&](double fromX, double fromY, double toX, double toY) {
        arena.box({fromX, fromY, 0}, {toX, toY, 1.2});
    };
    wall(-4.1, -4.1, 4.1, -4.0);
    wall(-4.1, 4.0, 4.1, 4.1);
    wall(-4.1, -4.0, -4.0, 4.0);
    wall(4.0, -4.0, 4.1, 4.0);
    arena.ramp({0.5, 2.5, 0}, degrees(20), 1.5, 1.2);
    arena.ramp({-3.0, 2.5, 0}, degrees(35), 0.8, 1.0);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> place(-3.5, 3.5), size(0.05, 0.5), height(0.02, 0.5);
    for (int i = 0; i < 40; ++i) {
        const double x = place(random), y = place(random);
        if (std::hypot(x, y) < 0.8) continue;
        const bool victim = i % 10 == 0;
        arena.box({x, y, 0}, {x + size(random), y + size(random), height(random)},
                  victim ? ElementKind::Victim : ElementKind::Rubble, "thing " + std::to_string(i));
    }
    return arena;
}

/// @p commands random voltages, brakes and lengths of steps for both robots; robots that lie on their side
/// are replaced by new worlds.
void driveAtRandom(int commands, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> voltage(-1.3, 1.3);
    std::uniform_int_distribution<int> microseconds(1, 40'000), dice(0, 99);
    int driven = 0, worlds = 0, tips = 0;
    std::size_t bumps = 0;
    while (driven < commands) {
        World world = yard(seed + static_cast<std::uint64_t>(worlds)).world(seed);
        ++worlds;
        world.addRobot(kurt3dBody(), poseFrom({0, 0.35, 0}, 0, 0, 0.3));
        world.addRobot(crawlerBody(), poseFrom({0, -0.35, 0}, 0, 0, 2.0));
        bool tipped = false;
        for (int i = 0; i < 2'000 && driven < commands && !tipped; ++i, ++driven) {
            for (const int robot : {0, 1}) {
                if (dice(random) < 10) world.setMotors(robot, voltage(random), voltage(random));
                if (dice(random) < 2) world.setBrake(robot, dice(random) < 30);
                if (dice(random) == 0) world.setMotors(robot, std::nan(""), INFINITY);
            }
            world.advance(std::chrono::microseconds(microseconds(random)));
            for (const int robot : {0, 1}) {
                const BodyState& state = world.state(robot);
                ASSERT_TRUE(state.baseInArena.matrix().allFinite()) << "command " << driven;
                ASSERT_TRUE(state.linear.allFinite() && state.angular.allFinite());
                ASSERT_TRUE(std::isfinite(state.left) && std::isfinite(state.rightCurrent));
                ASSERT_TRUE(std::isfinite(state.travelledLeft));
                const Eigen::Vector3d at = state.baseInArena.translation();
                ASSERT_LT(at.head<2>().cwiseAbs().maxCoeff(), 4.0) << "through the wall, command " << driven;
                ASSERT_GT(at.z(), -0.15) << "through the floor, command " << driven;
                ASSERT_LT(at.z(), 1.5);
                ASSERT_LT((state.baseInArena.linear() * state.baseInArena.linear().transpose() -
                           Eigen::Matrix3d::Identity())
                              .norm(),
                          1e-9);
                ASSERT_LT(std::abs(state.linear.x()), 5.0) << "command " << driven;
                tipped = tipped || state.tipped;
            }
        }
        tips += tipped ? 1 : 0;
        bumps += world.bumps().size();
    }
    std::printf("%d commands in %d worlds: %zu bumps, %d robots on their side\n", driven, worlds, bumps,
                tips);
    EXPECT_GT(bumps, 0U);
}

TEST(RandomDrive, StaysFiniteAndInsideItsWalls) {
    driveAtRandom(10'000, /*seed=*/41);
}

TEST(RandomDriveLong, StaysFiniteForAMillionCommands) {
    driveAtRandom(1'000'000, /*seed=*/42);
}

}  // namespace
}  // namespace leitstand::simulation
