#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "tests/simulation/drives/driven_world.h"
#include "tests/simulation/drives/rooms.h"

namespace leitstand::simulation::test {
namespace {

DriveSetup blindToHeat(const std::string& kind = "kurt3d") {
    DriveSetup setup;
    setup.kind = kind;
    setup.infrared = false;
    return setup;
}

/// The sticks are let go of, then pushed: the robot drives.
void driveOff(DrivenWorld& driven, double forward, double seconds) {
    driven.drive(0.0, 0.0, 0.3);
    driven.drive(forward, 0.0, seconds);
}

TEST(LinkLoss, TeleoperationStandsWithinTheWatchdogsTime) {
    DrivenWorld driven(room(8.0, 3.0), blindToHeat());
    driveOff(driven, 0.4, 3.0);
    EXPECT_GT(driven.speed(), 0.3);
    driven.radio = false;
    driven.pass(0.14);
    EXPECT_GT(driven.speed(), 0.3) << "a hiccup is bridged";
    driven.pass(0.26);
    EXPECT_LT(driven.speed(), 0.01) << "0.2 s after the last command, and the time to brake";
    const Eigen::Vector2d stood = driven.place();
    driven.pass(5.0);
    EXPECT_NE(driven.reason().find("link lost"), std::string::npos) << driven.reason();
    driven.radio = true;
    driven.pass(1.0);  // the sticks are still pushed
    EXPECT_LT((driven.place() - stood).norm(), 0.01) << "nothing begins by itself";
    driveOff(driven, 0.3, 1.0);
    EXPECT_GT((driven.place() - stood).norm(), 0.15);
}

/// How long a robot that drives at 0.2 m/s goes on truly, after its station is gone @p steps of 5 ms after
/// one of its commands [s].
double standsAfter(DrivenWorld& driven, double speed, int steps) {
    driven.radio = true;
    driven.pass(1.0 - std::fmod(driven.world->seconds(), 1.0));  // the next command comes with the next step
    driveOff(driven, speed, 2.0);
    EXPECT_NEAR(driven.speed(), std::abs(speed), 0.03);
    driven.pass(0.005 * (1 + steps));
    driven.radio = false;
    const double gone = driven.world->seconds();
    while (driven.speed() >= 0.01 && driven.world->seconds() < gone + 1.0) driven.pass(0.005);
    const double took = driven.world->seconds() - gone;
    driven.pass(0.5);
    EXPECT_LT(driven.speed(), 0.01) << "for good";
    return took;
}

TEST(LinkLoss, ARobotWhoseStationDiesStandsWithinThreeTenthsOfASecond) {
    for (const std::string kind : {"kurt3d", "crawler"}) {
        DrivenWorld driven(room(8.0, 3.0), blindToHeat(kind));
        double least = 1.0, most = 0.0;
        for (int i = 0; i < 20; ++i) {  // at each moment between two commands, to and fro
            const double took = standsAfter(driven, i % 2 == 0 ? 0.2 : -0.2, i / 2);
            least = std::min(least, took);
            most = std::max(most, took);
            EXPECT_LE(took, 0.3) << kind << ", gone " << 5 * (i / 2) << " ms after a command";
        }
        std::printf("%s stands %.0f to %.0f ms after its station is gone\n", kind.c_str(), 1e3 * least,
                    1e3 * most);
    }
}

TEST(LinkLoss, SafeTeleoperationStands) {
    DrivenWorld driven(room(8.0, 3.0), blindToHeat());
    driven.ask("safe_teleoperation");
    driven.pass(3.0);
    driveOff(driven, 0.4, 2.0);
    EXPECT_GT(driven.speed(), 0.2);
    driven.radio = false;
    driven.pass(0.7);
    EXPECT_LT(driven.speed(), 0.01);
}

/// Two rooms, one behind the other, with a way between them along the north wall: there is no straight way
/// back.
Arena corner() {
    Arena arena = room(6.0, 3.0);
    arena.elements.push_back(wall("between", {2.6, 0.0}, {2.6, 1.9}));
    arena.starts["kurt3d"] = arena.starts["crawler"] = poseFrom({0.8, 0.8, 0.0}, 0.0, 0.0, 0.0);
    return arena;
}

PoseSample goalAt(const DrivenWorld& driven, const std::string& frame, const Eigen::Vector2d& inArena) {
    PoseSample goal;
    goal.header.frame = frame;
    const Pose& start = driven.world->arena().starts.at("kurt3d");
    goal.poseInFrame.translation() = start.inverse() * Eigen::Vector3d(inArena.x(), inArena.y(), 0.0);
    return goal;
}

class OfBothRobots : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Drives, OfBothRobots, testing::Values("kurt3d", "crawler"),
                         [](const auto& info) { return std::string(info.param); });

TEST_P(OfBothRobots, ExploringReturnsToWhereTheRadioReachedIt) {
    DrivenWorld driven(corner(), blindToHeat(GetParam()));
    driven.pass(0.5);
    driven.ask("explore");
    driven.station->publish(StreamRole::GoalPose, goalAt(driven, "odom", {5.2, 0.7}));
    // The radio reaches only the first room; the robot goes on until the silence counts as a lost link.
    while (driven.world->seconds() < 120.0 && driven.place().x() < 2.4) driven.pass(0.1);
    ASSERT_GE(driven.place().x(), 2.4) << driven.reason();
    const Eigen::Vector2d lost = driven.place();
    driven.radio = false;
    double farthest = 0.0;
    while (driven.world->seconds() < 200.0 && driven.reason().find("back where") == std::string::npos) {
        driven.pass(0.1);
        farthest = std::max(farthest, (driven.place() - lost).norm());
    }
    EXPECT_NE(driven.reason().find("is back where it was good"), std::string::npos) << driven.reason();
    EXPECT_GT(farthest, 0.15) << "it had gone on for three seconds";
    EXPECT_LT((driven.place() - lost).norm(), 0.5) << "where the radio was good last";
    driven.pass(3.0);
    EXPECT_LT(driven.speed(), 0.01) << "waits";
    driven.radio = true;
    driven.pass(2.0);
    EXPECT_LT(driven.speed(), 0.01) << "until it is asked again";
    driven.ask("explore");
    driven.pass(5.0);
    EXPECT_GT((driven.place() - lost).norm(), 0.1);
    EXPECT_EQ(driven.bumps(), 0);
}

TEST(LinkLoss, AnApproachIsFinishedAndWaits) {
    Arena arena = room(6.0, 3.0);
    arena.elements.push_back(warmVictim({4.6, 1.5}, degrees(100)));
    DrivenWorld driven(arena, {});
    driven.pass(0.5);
    driven.ask("explore");
    while (driven.world->seconds() < 60.0 && driven.mode() != DriveMode::VictimApproach) driven.pass(0.1);
    ASSERT_EQ(driven.mode(), DriveMode::VictimApproach) << driven.reason();
    driven.radio = false;
    while (driven.world->seconds() < 120.0 && driven.sightings.empty()) driven.pass(0.1);
    ASSERT_EQ(driven.sightings.size(), 1U) << driven.reason();
    driven.pass(5.0);
    EXPECT_LT(driven.speed(), 0.01);
    EXPECT_NEAR(driven.fromFrontTo("victim"), 0.8, 0.05);
    EXPECT_NE(driven.reason().find("waits"), std::string::npos) << driven.reason();
}

TEST_P(OfBothRobots, AGoalIsReachedAroundACorner) {
    for (const std::string frame : {"odom", "base_link"}) {
        DrivenWorld driven(corner(), blindToHeat(GetParam()));
        driven.pass(0.5);
        driven.ask("explore");
        const Eigen::Vector2d goal(4.8, 0.8);
        driven.station->publish(StreamRole::GoalPose, goalAt(driven, frame, goal));
        while (driven.world->seconds() < 120.0 && driven.reason() != "at the goal") driven.pass(0.1);
        EXPECT_EQ(driven.reason(), "at the goal");
        EXPECT_LT((driven.place() - goal).norm(), 0.45) << frame;
        driven.pass(3.0);
        EXPECT_LT(driven.speed(), 0.01) << "waits there";
        EXPECT_EQ(driven.bumps(), 0);
        std::printf("%s at the goal (%s) after %.0f s, %.2f m off\n", GetParam(), frame.c_str(),
                    driven.world->seconds(), (driven.place() - goal).norm());
    }
}

TEST(Goal, BehindWallsIsGivenUp) {
    Arena arena = room(6.0, 3.0);
    arena.elements.push_back(wall("between", {3.0, 0.0}, {3.0, 3.0}));
    DrivenWorld driven(arena, blindToHeat());
    driven.pass(0.5);
    driven.ask("explore");
    driven.station->publish(StreamRole::GoalPose, goalAt(driven, "odom", {5.0, 1.5}));
    while (driven.world->seconds() < 120.0 && driven.reason().find("no way") == std::string::npos)
        driven.pass(0.1);
    EXPECT_NE(driven.reason().find("no way to the goal"), std::string::npos) << driven.reason();
    driven.pass(2.0);
    EXPECT_LT(driven.speed(), 0.01);
    EXPECT_EQ(driven.bumps(), 0);
}

}  // namespace
}  // namespace leitstand::simulation::test
