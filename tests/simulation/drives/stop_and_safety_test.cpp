#include <cmath>

#include <gtest/gtest.h>

#include "core/event/stream_role.h"
#include "tests/simulation/drives/driven_world.h"
#include "tests/simulation/drives/rooms.h"

namespace leitstand::simulation::test {
namespace {

DriveSetup blindToHeat() {
    DriveSetup setup;
    setup.infrared = false;
    return setup;
}

double frontToEastWall(const DrivenWorld& driven, double x) {
    return x - 0.025 - (driven.state().baseInArena * Eigen::Vector3d(0.225, 0.0, 0.0)).x();
}

StopStateSample stopState(const DrivenWorld& driven) {
    const auto states = driven.station->all<StopStateSample>();
    return states.empty() ? StopStateSample{} : states.back();
}

TEST(Stop, StandsOnARampUntilItIsReleased) {
    Arena arena = room(8.0, 3.0);
    arena.elements.push_back(rampAt(2.0, 3.0, 3.0, degrees(15)));
    DrivenWorld driven(arena, blindToHeat());
    driven.drive(0.0, 0.0, 0.3);
    driven.drive(0.4, 0.0, 6.5);
    ASSERT_GT(driven.state().baseInArena.translation().z(), 0.1) << "on the ramp";
    driven.station->stop(1);
    driven.pass(0.5);
    EXPECT_LT(driven.speed(), 0.01);
    EXPECT_TRUE(stopState(driven).stopped && stopState(driven).standing);
    const Eigen::Vector2d stood = driven.place();
    driven.pass(20.0);  // the sticks are pushed all the time
    EXPECT_LT((driven.place() - stood).norm(), 0.01) << "it does not creep";
    EXPECT_EQ(driven.mode(), DriveMode::Stopped);
    driven.ask("explore");
    EXPECT_EQ(driven.mode(), DriveMode::Stopped) << "modes wait for the release";
    driven.station->stop(2, false, stopState(driven).stops + 1);
    driven.pass(0.2);
    EXPECT_TRUE(stopState(driven).stopped) << "names a stop that its operator cannot have seen";
    driven.station->stop(3, false, stopState(driven).stops);
    driven.pass(1.0);
    EXPECT_FALSE(stopState(driven).stopped);
    EXPECT_LT((driven.place() - stood).norm(), 0.01) << "the sticks must be neutral first";
    driven.drive(0.0, 0.0, 0.3);
    driven.drive(-0.3, 0.0, 2.0);
    EXPECT_GT((driven.place() - stood).norm(), 0.3);
}

TEST(Stop, HaltsExploringAndNothingBeginsByItself) {
    DrivenWorld driven(room(6.0, 4.0), blindToHeat());
    driven.pass(0.5);
    driven.ask("explore");
    while (driven.world->seconds() < 40.0 && driven.speed() < 0.1) driven.pass(0.1);
    ASSERT_GE(driven.speed(), 0.1);
    driven.station->stop(1);
    driven.pass(0.6);
    EXPECT_LT(driven.speed(), 0.01);
    const Eigen::Vector2d stood = driven.place();
    driven.station->stop(2, false, stopState(driven).stops);
    driven.pass(5.0);
    EXPECT_EQ(driven.mode(), DriveMode::Teleoperation) << "released into the operator's hands";
    EXPECT_LT((driven.place() - stood).norm(), 0.01);
}

TEST(SafeTeleoperation, FullAheadAtAWallStopsBeforeItAndSidewaysSlips) {
    for (const double turn : {0.0, 0.25}) {
        DrivenWorld driven(room(5.0, 4.0), blindToHeat());
        driven.ask("safe_teleoperation");
        driven.pass(3.0);
        driven.drive(0.0, 0.0, 0.3);
        double fastest = 0.0;
        driven.sticks = DriveVelocity{0.6, 0.0, turn};
        for (int i = 0; i < 250; ++i) {
            driven.pass(0.1);
            fastest = std::max(fastest, driven.speed());
        }
        EXPECT_GT(fastest, 0.3) << turn;
        EXPECT_EQ(driven.bumps(), 0) << turn;
        EXPECT_LT(driven.speed(), 0.12) << turn;
        if (turn != 0.0) continue;
        EXPECT_GT(frontToEastWall(driven, 5.0), 0.02);
        EXPECT_LT(frontToEastWall(driven, 5.0), 0.25) << "and gets close to it";
        driven.drive(0.0, 0.0, 0.3);
        driven.drive(-0.4, 0.0, 2.0);
        EXPECT_GT(frontToEastWall(driven, 5.0), 0.3) << "away from it";
    }
}

TEST(SafeTeleoperation, SlowsDownWhenTheScannerIsSilent) {
    DrivenWorld driven(room(12.0, 3.0), blindToHeat());
    driven.ask("safe_teleoperation");
    driven.pass(5.0);
    driven.drive(0.0, 0.0, 0.3);
    driven.drive(0.5, 0.0, 2.0);
    EXPECT_GT(driven.speed(), 0.3);
    driven.hardware->breakSensor(StreamRole::Points);
    driven.drive(0.0, 0.0, 5.0);
    driven.drive(0.5, 0.0, 1.5);
    EXPECT_GT(driven.speed(), 0.02);
    EXPECT_LT(driven.speed(), 0.13) << "what it saw is seven seconds old";
}

TEST(Teleoperation, TheOperatorMayTouchAWall) {
    DrivenWorld driven(room(5.0, 4.0), blindToHeat());
    driven.drive(0.0, 0.0, 0.3);
    driven.drive(0.6, 0.0, 8.0);
    EXPECT_EQ(driven.bumps(), 1) << "plain teleoperation obeys, and tells the bump";
    const auto bumps = driven.station->all<BumpSample>();
    ASSERT_FALSE(bumps.empty());
}

}  // namespace
}  // namespace leitstand::simulation::test
