#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/simulation/world/operated_robot.h"
#include "tests/simulation/world/test_arena.h"

namespace leitstand::simulation {
namespace {

/// How a chain answered a step of what is asked for.
struct Response {
    double settled = 0.0;    ///< from then on within 5 % of the step [s]
    double overshoot = 0.0;  ///< as a share of the step
    double last = 0.0;       ///< speed at the end [m/s]
};

/// Asks for @p forward and @p turn for a second and looks at the left chain, which shall go from @p from to
/// @p wanted. Slip, which jumps every half second by 2 % of the speed, is not the controller's.
Response respond(OperatedRobot& robot, double forward, double turn, double wanted, double from) {
    Response response;
    robot.request(forward, turn);
    const double begin = robot.world().seconds();
    const double slips = std::abs(from) > 0.01 ? 0.02 * std::abs(wanted / (wanted - from)) : 0.0;
    pass(robot.world(), {&robot}, 1.0, [&](OperatedRobot& one) {
        const double done = (one.state().left - from) / (wanted - from);
        response.overshoot = std::max(response.overshoot, done - 1.0 - slips);
        if (std::abs(done - 1.0) > 0.05 + slips) response.settled = one.world().seconds() - begin;
    });
    response.last = robot.state().left;
    return response;
}

TEST(CrawlerDrive, EachStepSettlesWithinThreeTenthsOfASecond) {
    const double half = 0.5 * 0.20 / 0.7;  // of the track, as its controller sees it
    for (const auto period : {std::chrono::milliseconds(5), std::chrono::milliseconds(10)}) {
        World world = TestArena().world();
        OperatedRobot robot(world, "crawler", Pose::Identity());
        robot.turnEvery(period);
        const auto check = [&](double forward, double turn) {
            pass(world, {&robot}, 0.1);
            const double from = robot.state().left, wanted = forward - half * turn;
            const Response response = respond(robot, forward, turn, wanted, from);
            std::printf("left chain from %.2f to %.2f m/s: settles in %.2f s, overshoot %.1f %%\n", from,
                        wanted, response.settled, 100 * response.overshoot);
            EXPECT_LE(response.settled, 0.3) << from << " to " << wanted;
            EXPECT_LT(response.overshoot, 0.10) << from << " to " << wanted;
        };
        for (const double forward : {0.1, 0.2, 0.3, 0.5, -0.3, -0.1}) {
            check(forward, 0.0);
            check(0.0, 0.0);
        }
        check(0.2, 0.0);
        check(0.4, 0.0);
        check(0.0, 1.5);
        check(0.0, 0.0);
        check(0.2, -0.8);
    }
}

TEST(CrawlerDrive, HoldsItsSpeedOnARampOfThirtyDegrees) {
    TestArena arena;
    arena.ramp({1, 0, 0}, degrees(30), 6);
    World world = arena.world();
    OperatedRobot robot(world, "crawler", poseFrom({1.8, 0, 1.0}, 0, 0, 0));
    pass(world, {&robot}, 0.5);
    EXPECT_NEAR(inDegrees(pitchOf(robot.state())), -30.0, 0.2);
    for (const double wanted : {0.2, -0.2, 0.1}) {
        const Response response = respond(robot, wanted, 0.0, wanted, robot.state().left);
        std::printf("on 30 degrees to %.1f m/s: settles in %.2f s, overshoot %.1f %%\n", wanted,
                    response.settled, 100 * response.overshoot);
        EXPECT_LE(response.settled, 0.3) << wanted << ", against the slope";
        EXPECT_LT(response.overshoot, 0.10) << wanted;
        double least = 1.0, most = -1.0;
        pass(world, {&robot}, 3.0, [&](OperatedRobot& one) {
            for (const double speed : {one.state().left, one.state().right}) {
                least = std::min(least, speed);
                most = std::max(most, speed);
            }
        });
        EXPECT_NEAR(least, wanted, 0.007) << "slip jumps by 2 % and more";
        EXPECT_NEAR(most, wanted, 0.007);
    }
    robot.request(0.0);
    pass(world, {&robot}, 0.5);
    const Pose held = robot.state().baseInArena;
    pass(world, {&robot}, 5.0);
    EXPECT_LT(distanceBetween(held, robot.state().baseInArena), 1e-4) << "stands on it, by its brake";
}

TEST(CrawlerDrive, AStallLeavesNothingBehind) {
    for (const double after : {0.4, -0.3}) {
        World world = TestArena().world();
        OperatedRobot robot(world, "crawler", Pose::Identity());
        const int other = world.addGhost(kurt3dBody());
        world.placeGhost(other, poseFrom({0.6, 0, 0}, 0, 0, degrees(90)));
        robot.request(0.4);
        pass(world, {&robot}, 6.0);
        EXPECT_TRUE(robot.state().blocked);
        EXPECT_NEAR(robot.state().linear.x(), 0.0, 1e-3);
        EXPECT_LT(robot.state().left, 0.35) << "motors at their limit";
        EXPECT_GT(robot.state().leftCurrent, 4.0);
        world.placeGhost(other, poseFrom({8, 8, 0}, 0, 0, 0));
        const Response response = respond(robot, after, 0.0, after, 0.0);
        std::printf("after a stall to %.1f m/s: settles in %.2f s, overshoot %.1f %%\n", after,
                    response.settled, 100 * response.overshoot);
        EXPECT_LE(response.settled, after > 0 ? 0.3 : 0.45) << "0.7 m/s of difference take 0.25 s to ask for";
        EXPECT_LT(response.overshoot, 0.10);
        EXPECT_NEAR(response.last, after, 0.01);
    }
}

}  // namespace
}  // namespace leitstand::simulation
