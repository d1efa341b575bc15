#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/event/motion_samples.h"
#include "tests/simulation/world/operated_robot.h"
#include "tests/simulation/world/test_arena.h"

namespace leitstand::simulation {
namespace {

TwistSample ahead(double speed) {
    TwistSample twist;
    twist.linear.x() = speed;
    return twist;
}

/// What its diagnostics say of @p name, in their order.
std::vector<DiagnosticStatus> eventsOf(const OperatedRobot& robot, const std::string& name) {
    std::vector<DiagnosticStatus> reported;
    for (const DiagnosticsSample& sample : robot.all<DiagnosticsSample>()) {
        for (const DiagnosticStatus& status : sample.statuses) {
            if (status.name == name) reported.push_back(status);
        }
    }
    return reported;
}

bool wasSaid(const OperatedRobot& robot, const std::string& name, DiagnosticStatus::Level level) {
    const auto reported = eventsOf(robot, name);
    return std::any_of(reported.begin(), reported.end(),
                       [&](const auto& status) { return status.level == level; });
}

TEST(CrawlerLife, TheRemoteGoesBeforeTheStationAndIsSeenInTheMode) {
    World world = TestArena().world();
    OperatedRobot robot(world, "crawler", Pose::Identity());
    const auto x = [&] { return robot.state().baseInArena.translation().x(); };
    robot.request(0.3);
    pass(world, {&robot}, 2.0);
    EXPECT_GT(x(), 0.4);
    EXPECT_EQ(robot.all<ModeSample>().back().mode, "teleoperation");
    robot.remote(ahead(-0.2));
    pass(world, {&robot}, 0.5);
    const double before = x();
    EXPECT_EQ(robot.all<ModeSample>().back().mode, "remote");
    pass(world, {&robot}, 1.0);
    EXPECT_NEAR(x() - before, -0.2 * 0.97, 0.03) << "back, whatever the station says";
    robot.remote(ahead(0.0));  // held, with its stick in the middle: it still goes before
    pass(world, {&robot}, 1.0);
    EXPECT_EQ(robot.all<ModeSample>().back().mode, "remote");
    EXPECT_EQ(robot.state().linear.x(), 0.0);
    robot.remote(std::nullopt);
    pass(world, {&robot}, 1.5);
    EXPECT_EQ(robot.all<ModeSample>().back().mode, "teleoperation");
    EXPECT_EQ(robot.state().linear.x(), 0.0) << "the station's sticks must be neutral first";
    robot.request(0.0);
    pass(world, {&robot}, 0.2);
    robot.request(0.3);
    pass(world, {&robot}, 0.5);
    EXPECT_NEAR(robot.state().left, 0.3, 0.01);
    robot.remote(ahead(0.3));
    robot.stop();
    pass(world, {&robot}, 0.5);
    EXPECT_EQ(robot.state().linear.x(), 0.0) << "a stop is above the remote";
    EXPECT_EQ(robot.all<ModeSample>().back().mode, "stopped");
}

TEST(CrawlerLife, ItsBatteryFallsFasterWhereItClimbs) {
    TestArena arena;
    arena.ramp({1, 0, 0}, degrees(25), 12);
    const auto drawn = [&](const Pose& start, double speed) {
        World world = arena.world();
        OperatedRobot robot(world, "crawler", start);
        robot.request(speed);
        pass(world, {&robot}, 20.0);
        const auto reported = robot.all<BatterySample>();
        EXPECT_NEAR(static_cast<double>(reported.size()), 20.0, 1.0);
        for (std::size_t i = 1; i < reported.size(); ++i)
            EXPECT_LT(reported[i].fraction, reported[i - 1].fraction);
        EXPECT_LT(reported.back().voltage, 16.4);
        return reported.front().charge - reported.back().charge;
    };
    const double standing = drawn(Pose::Identity(), 0.0);
    const double driving = drawn(poseFrom({0, 3, 0}, 0, 0, 0), 0.3);
    const double climbing = drawn(poseFrom({2, 0, 1}, 0, 0, 0), 0.3);
    std::printf("drawn in 20 s: %.1f mAh standing, %.1f driving, %.1f on 25 degrees\n", 1e3 * standing,
                1e3 * driving, 1e3 * climbing);
    EXPECT_NEAR(standing, 1.6 * 19 / 3600, 0.002) << "its electronics";
    EXPECT_GT(driving, 1.2 * standing);
    EXPECT_GT(climbing, 1.5 * driving);
}

TEST(CrawlerLife, WarnsBeforeItRollsOverAndTellsThatItDid) {
    // Along a slope, with a board under its upper chain in the end.
    const double slope = degrees(44);
    TestArena arena;
    arena.ramp({0, 0, 0}, slope, 4, 8);
    const Pose onSlope = poseFrom({2, 0, 2 * std::tan(slope)}, 0, -slope, 0);
    addBox(arena.mesh.still, arena.surface(ElementKind::Rubble, "board"), onSlope, {0.03, 1, -0.02},
           {0.4, 3, 0.075});
    World world = arena.world();
    OperatedRobot robot(world, "crawler", poseFrom({2, 0, 2.2}, 0, 0, degrees(90)));
    double warned = -1.0, tipped = -1.0;
    pass(world, {&robot}, 12.0, [&](OperatedRobot& one) {
        one.wishHeading(0.2, degrees(90));
        if (warned < 0 && wasSaid(one, "roll-over", DiagnosticStatus::Level::Warning))
            warned = world.seconds();
        if (tipped < 0 && one.state().tipped) tipped = world.seconds();
        EXPECT_TRUE(tipped > 0 || !wasSaid(one, "roll-over", DiagnosticStatus::Level::Error) ||
                    std::abs(rollOf(one.state())) > degrees(60));
    });
    ASSERT_GT(tipped, 0.0);
    ASSERT_GT(warned, 0.0);
    std::printf("warned %.1f s before it lay on its side\n", tipped - warned);
    EXPECT_GT(tipped - warned, 1.0) << "time to let go of the sticks";
    const auto reported = eventsOf(robot, "roll-over");
    EXPECT_EQ(reported.back().level, DiagnosticStatus::Level::Error);
    EXPECT_EQ(reported.back().message, "rolled over");
    EXPECT_TRUE(wasSaid(robot, "attitude", DiagnosticStatus::Level::Error));
}

TEST(CrawlerLife, FallsOffALedgeSideways) {
    TestArena arena;
    arena.box({-3, 0, 0}, {5, 3, 0.5}, ElementKind::Floor, "upper level");
    World world = arena.world();
    OperatedRobot robot(world, "crawler", poseFrom({0, 0.3, 0.6}, 0, 0, degrees(-15)));
    robot.request(0.2);
    pass(world, {&robot}, 12.0);
    EXPECT_TRUE(robot.state().tipped);
    EXPECT_EQ(eventsOf(robot, "roll-over").back().message, "rolled over");
}

TEST(CrawlerLife, TipsOnASideSlopeThatItsWeightDoesNotHoldAndNotBefore) {
    for (const double slope : {30.0, 45.0, 65.0}) {
        TestArena arena;
        arena.ramp({0, 0, 0}, degrees(slope), 3, 8);
        World world = arena.world();
        OperatedRobot robot(world, "crawler",
                            poseFrom({1.5, 0, 1.5 * std::tan(degrees(slope)) + 0.1}, 0, 0, degrees(90)));
        pass(world, {&robot}, 2.5);
        EXPECT_EQ(robot.state().tipped, slope > 60.0) << slope;
        EXPECT_EQ(wasSaid(robot, "attitude", DiagnosticStatus::Level::Error), slope > 60.0) << slope;
        EXPECT_TRUE(wasSaid(robot, "roll-over", DiagnosticStatus::Level::Warning) ||
                    wasSaid(robot, "roll-over", DiagnosticStatus::Level::Error))
            << slope;
    }
}

}  // namespace
}  // namespace leitstand::simulation
