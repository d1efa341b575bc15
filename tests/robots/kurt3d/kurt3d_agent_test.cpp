#include "robots/kurt3d/kurt3d_agent.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/event/cloud_sample.h"
#include "core/event/command_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/stream_role.h"
#include "core/io/robot/robot_file.h"
#include "core/robot/robot_format.h"
#include "robots/control/fuzzy/fuzzy_file.h"
#include "tests/support/fake_robot.h"
#include "tests/support/places.h"

namespace leitstand::test {
namespace {

struct Kurt3d : testing::Test {
    Kurt3d() {
        const std::string resources = sourceFolder() + "/resources/";
        const auto rules = readFuzzySystem(resources + "control/fuzzy_drive.yaml");
        const auto description = readRobot(resources + "robots/kurt3d.yaml");
        agent = Kurt3dAgent::create(robot, *description, *rules).value();
        station.emplace(robot, *agent, "kurt3d");
        other.emplace(robot, *agent, "kurt3d", std::uint8_t{2});
    }
    FakeRobot robot;
    std::unique_ptr<Kurt3dAgent> agent;
    std::optional<FakeStation<Kurt3dAgent>> station, other;
};

TEST_F(Kurt3d, BeginsStandingWithItsBrakeOn) {
    station->pass(0.1);
    EXPECT_TRUE(robot.brake);
    EXPECT_EQ(agent->mode(), DriveMode::Teleoperation);
    EXPECT_EQ(station->all<ModeSample>().size(), 1u);
    EXPECT_EQ(station->all<StopStateSample>().front().stopped, false);
}

TEST_F(Kurt3d, ObeysTheHolderOnly) {
    station->drive(0.0);
    station->drive(0.3);
    station->pass(0.1);
    EXPECT_EQ(robot.left, 0.0) << "no grant";
    station->keepDriving(0.0, 0.1);
    station->keepDriving(0.3, 0.5);
    EXPECT_NEAR(robot.tracks().left, 0.3, 0.03);
    other->drive(0.0);
    station->pass(0.05);
    EXPECT_GT(robot.left, 0.2) << "a stranger's zero does not count either";
}

TEST_F(Kurt3d, ObeysAModeThatOvertookTheGrantOfItsSender) {
    station->mode("explore");
    station->pass(0.1);
    EXPECT_EQ(agent->mode(), DriveMode::Teleoperation);
    station->hold();
    station->pass(0.1);
    EXPECT_EQ(agent->mode(), DriveMode::Explore);
}

TEST_F(Kurt3d, ForgetsAModeOfNoHolder) {
    other->mode("explore");
    station->hold();
    station->pass(0.1);
    EXPECT_EQ(agent->mode(), DriveMode::Teleoperation) << "the grant is another station's";
    station->mode("explore");
    station->pass(0.1);
    EXPECT_EQ(agent->mode(), DriveMode::Explore);
    station->mode("teleoperation");
    station->pass(1.5);
    EXPECT_EQ(agent->mode(), DriveMode::Teleoperation);
}

TEST_F(Kurt3d, AnOldWishIsNoWish) {
    station->mode("explore");
    station->pass(1.5);
    station->hold();
    station->pass(0.1);
    EXPECT_EQ(agent->mode(), DriveMode::Teleoperation);
}

TEST_F(Kurt3d, BrakesTwoHundredMillisecondsAfterTheLastCommand) {
    station->keepDriving(0.0, 0.1);
    station->keepDriving(0.3, 0.5);  // the last one is said 0.05 s before its end
    station->pass(0.14);
    EXPECT_GT(robot.left, 0.2);
    station->pass(0.02);
    EXPECT_EQ(robot.left, 0.0);
    EXPECT_TRUE(robot.brake);
}

TEST_F(Kurt3d, AStickThatWasHeldThroughAHangOfItsStationMovesNothingAndIsTold) {
    station->keepDriving(0.0, 0.1);
    station->keepDriving(0.3, 0.5);
    station->pass(0.5);
    station->keepDriving(0.3, 0.3);
    EXPECT_GT(robot.left, 0.2) << "a short gap is bridged";
    station->pass(1.0);
    station->keepDriving(0.3, 1.0);
    EXPECT_EQ(robot.left, 0.0);
    EXPECT_EQ(station->all<ModeSample>().back().reason, robot_format::NeutralFirst);
    station->keepDriving(0.0, 0.1);
    EXPECT_NE(station->all<ModeSample>().back().reason, robot_format::NeutralFirst);
    station->keepDriving(0.3, 0.5);
    EXPECT_GT(robot.left, 0.2);
}

TEST_F(Kurt3d, AStopStandsUntilTheHolderReleasesIt) {
    station->keepDriving(0.0, 0.1);
    station->keepDriving(0.3, 0.5);
    other->stop(1);
    station->pass(0.02);
    EXPECT_TRUE(robot.brake);
    EXPECT_EQ(robot.left, 0.0);
    station->keepDriving(0.3, 1.0);
    EXPECT_TRUE(robot.brake) << "commands do not lift it";
    EXPECT_EQ(agent->mode(), DriveMode::Stopped);
    const auto state = station->all<StopStateSample>().back();
    EXPECT_TRUE(state.stopped && state.standing);
    other->stop(2, false, state.stops);
    station->pass(0.05);
    EXPECT_FALSE(station->all<StopStateSample>().back().refused.empty()) << "not of the holder";
    station->stop(3, false, state.stops);
    station->pass(0.05);
    EXPECT_FALSE(station->all<StopStateSample>().back().stopped);
    station->keepDriving(0.3, 0.3);
    EXPECT_EQ(robot.left, 0.0) << "sticks must be neutral first";
    station->keepDriving(0.0, 0.1);
    station->keepDriving(0.3, 0.5);
    EXPECT_GT(robot.left, 0.2);
}

TEST_F(Kurt3d, EveryStopIsAnsweredAlsoARepeatedOne) {
    station->stop(7);
    station->pass(0.02);
    const auto before = station->all<StopStateSample>().size();
    station->stop(7);
    station->pass(0.02);
    EXPECT_EQ(station->all<StopStateSample>().size(), before + 1);
    EXPECT_EQ(station->all<StopStateSample>().back().number, 7u);
}

TEST_F(Kurt3d, ModesAreTheHoldersToAskFor) {
    station->keepDriving(0.0, 0.1);
    other->mode("safe_teleoperation");
    station->pass(0.02);
    EXPECT_EQ(agent->mode(), DriveMode::Teleoperation);
    station->mode("safe_teleoperation");
    station->pass(0.02);
    EXPECT_EQ(agent->mode(), DriveMode::SafeTeleoperation);
    EXPECT_EQ(station->all<ModeSample>().back().mode, "safe_teleoperation");
    station->mode("victim_approach");
    station->pass(0.02);
    EXPECT_EQ(agent->mode(), DriveMode::SafeTeleoperation) << "nothing warm is in sight";
    EXPECT_NE(station->all<ModeSample>().back().reason, "");
}

TEST_F(Kurt3d, WhatWasNeverSeenIsCreptIntoUnderSafeTeleoperation) {
    station->keepDriving(0.0, 0.1);
    station->mode("safe_teleoperation");
    station->keepDriving(0.0, 0.1);
    station->keepDriving(0.5, 1.0);
    EXPECT_GT(robot.tracks().left, 0.02);
    EXPECT_LT(robot.tracks().left, 0.15);
}

TEST_F(Kurt3d, ALostLinkStopsTeleoperationAndNothingBeginsByItself) {
    station->keepDriving(0.0, 0.1);
    station->mode("explore");
    station->pass(0.05);
    ASSERT_EQ(agent->mode(), DriveMode::Explore);
    station->pass(4.0);
    EXPECT_EQ(robot.left, 0.0);
    station->mode("teleoperation");
    station->pass(4.0);
    EXPECT_TRUE(robot.brake);
    station->keepDriving(0.3, 0.3);
    EXPECT_EQ(robot.left, 0.0) << "sticks must be neutral first";
}

TEST_F(Kurt3d, PingsComeBackWithItsClock) {
    station->publish(StreamRole::Ping, PingSample{42, "station 1", Time(std::chrono::seconds(5))});
    station->pass(0.01);
    const auto pongs = station->all<PongSample>();
    ASSERT_EQ(pongs.size(), 1u);
    EXPECT_EQ(pongs[0].number, 42u);
    EXPECT_EQ(pongs[0].sent, Time(std::chrono::seconds(5)));
    EXPECT_EQ(pongs[0].received, Time(std::chrono::seconds(1'000)));
}

TEST_F(Kurt3d, CamerasTurnAndStreamsAreSet) {
    station->hold();
    PanTiltCommand look;
    look.names = {"left_pan", "left_tilt"};
    look.positions = {0.5, -0.2};
    station->publish(StreamRole::PanTiltCommand, look);
    EXPECT_EQ(robot.cameras["left"], std::make_pair(0.5, -0.2));
    StreamCommandSample slow;
    slow.topic = "/kurt3d/left/image/compressed";
    slow.rate = 2.0;
    station->publish(StreamRole::StreamCommand, slow);
    EXPECT_EQ((robot.streams[{StreamRole::Picture, "left"}].rate), 2.0);
}

TEST_F(Kurt3d, LooksAsideForHeatWhileItExploresUnlessTheOperatorLooks) {
    station->keepDriving(0.0, 0.1);
    station->mode("explore");
    double least = 0.0, most = 0.0;
    for (int i = 0; i < 130; ++i) {
        station->hold();
        station->pass(0.1);
        least = std::min(least, robot.cameras["right"].first);
        most = std::max(most, robot.cameras["right"].first);
    }
    EXPECT_LT(least, degrees(-60));
    EXPECT_GT(most, degrees(60));
    PanTiltCommand look;
    look.names = {"right_pan", "right_tilt"};
    look.positions = {0.5, 0.2};
    station->publish(StreamRole::PanTiltCommand, look);
    for (int i = 0; i < 90; ++i) {
        station->hold();
        station->pass(0.1);
        ASSERT_EQ(robot.cameras["right"], std::make_pair(0.5, 0.2)) << "the operator's for ten seconds";
    }
    station->pass(2.0);
    EXPECT_NE(robot.cameras["right"], std::make_pair(0.5, 0.2));
    station->mode("teleoperation");
    station->pass(0.1);
    EXPECT_EQ(robot.cameras["right"], std::make_pair(0.0, 0.0)) << "ahead again for the operator";
}

/// A plate in whose middle is something as warm as skin.
struct WarmPlate {
    double bearing = 0.0, away = 1.0;  ///< from base_link, left positive [rad], [m]
    double half = degrees(8);          ///< its width to each side [rad]
    bool clothed = false;              ///< lukewarm around what is warm
    /// The column of the infrared picture in which its middle is.
    [[nodiscard]] int column() const { return 80 - static_cast<int>(std::lround(220.0 * std::tan(bearing))); }
};

/// What Kurt3D measures where it stands: walls of a room of 6 m, and @p plates.
void show(FakeRobot& robot, const std::vector<WarmPlate>& plates) {
    robot.samples.push_back(
        {StreamRole::Transforms,
         {},
         TransformsSample{{{{robot.time, "base_link"}, "laser", poseFrom({0.0, 0.0, 0.2}, 0.0, 0.0, 0.0)}}}});
    RangesSample laser;
    laser.header = {robot.time, "laser"};
    laser.angleMin = -degrees(180);
    laser.angleStep = degrees(1);
    laser.rangeMin = 0.1, laser.rangeMax = 10.0;
    for (int i = 0; i < 360; ++i) {
        const double angle = laser.angleMin + i * laser.angleStep;
        double range = 3.0;
        for (const WarmPlate& one : plates) {
            if (std::abs(angle - one.bearing) < one.half) range = one.away / std::cos(angle - one.bearing);
        }
        laser.ranges.push_back(static_cast<float>(range));
    }
    robot.samples.push_back({StreamRole::Ranges, "scanner", laser});
    CameraInfoSample camera;
    camera.header = {robot.time, "infrared"};
    camera.width = 160, camera.height = 120;
    camera.intrinsics = {220, 0, 79.5, 0, 220, 59.5, 0, 0, 1};
    robot.samples.push_back({StreamRole::CameraInfo, "ir", camera});
    const auto bytes = std::make_shared<std::vector<std::byte>>();
    for (int i = 0; i < 160 * 120; ++i) {
        int centikelvin = 29'315;
        for (const WarmPlate& one : plates) {
            const int off = std::max(std::abs(i % 160 - one.column()), std::abs(i / 160 - 62));
            if (off <= 12 && one.clothed) centikelvin = 29'900;
            if (off <= 5) centikelvin = 30'750;
        }
        bytes->push_back(static_cast<std::byte>(centikelvin & 255));
        bytes->push_back(static_cast<std::byte>(centikelvin >> 8));
    }
    PictureSample picture;
    picture.header = {robot.time, "infrared"};
    picture.encoding = "16UC1";
    picture.width = 160, picture.height = 120, picture.step = 320;
    picture.content = {bytes, *bytes};
    robot.samples.push_back({StreamRole::Thermal, "ir", picture});
}

// It came back to a lamp at once after it had left it: what it had seen last was still a reason to begin.
TEST_F(Kurt3d, WhatItHasLeftIsNoReasonToBeginAgain) {
    const RobotDescription description = *readRobot(sourceFolder() + "/resources/robots/kurt3d.yaml");
    const double ahead = boxAround(description.footprint).front + 0.8;
    station->keepDriving(0.0, 0.1);
    station->mode("explore");
    for (int i = 0; i < 80; ++i) {
        station->hold();
        show(robot, {{.away = ahead}});
        station->pass(0.1);
    }
    int approaches = 0, lamps = 0;
    for (const ModeSample& mode : station->all<ModeSample>()) {
        if (mode.mode == "victim_approach" && mode.reason == "body heat in sight") ++approaches;
        if (mode.reason.find("no person") != std::string::npos) ++lamps;
    }
    EXPECT_EQ(approaches, 1);
    EXPECT_EQ(lamps, 1);
    EXPECT_EQ(agent->mode(), DriveMode::Explore);
    EXPECT_TRUE(station->all<SightingSample>().empty());
}

// A victim that it saw for a second beside another was never seen again: its floor was known.
TEST_F(Kurt3d, LooksAtTheVictimThatItWaitsBeforeAndThenForTheOneThatItPassedBy) {
    const RobotDescription description = *readRobot(sourceFolder() + "/resources/robots/kurt3d.yaml");
    const double ahead = boxAround(description.footprint).front + 0.8;
    const WarmPlate victim{.away = ahead, .clothed = true};
    const WarmPlate passed{.bearing = degrees(15), .away = 2.2, .half = degrees(4), .clothed = true};
    const auto passWith = [&](const std::vector<WarmPlate>& plates, double seconds) {
        for (int i = 0; i < static_cast<int>(10.0 * seconds + 0.5); ++i) {
            station->hold();
            show(robot, plates);
            station->pass(0.1);
        }
    };
    // Of the camera, which sits 0.19 m ahead of base_link, 0.08 m to its right and 0.36 m high.
    const auto pan = [&] { return robot.cameras["right"].first; };
    station->keepDriving(0.0, 0.1);
    station->mode("explore");
    passWith({victim}, 1.5);
    ASSERT_EQ(agent->mode(), DriveMode::VictimApproach);
    passWith({victim, passed}, 1.0);
    passWith({victim}, 6.0);
    ASSERT_EQ(station->all<SightingSample>().size(), 1U);
    EXPECT_NEAR(pan(), 0.0, degrees(3));
    station->mode("explore");
    passWith({victim}, 2.0);
    EXPECT_EQ(agent->mode(), DriveMode::Explore);
    const double towards = std::atan2(2.2 * std::sin(degrees(15)) + 0.08, 2.2 * std::cos(degrees(15)) - 0.19);
    double most = 0.0;
    for (int i = 0; i < 30; ++i) {
        passWith({victim}, 0.1);
        most = std::max(most, std::abs(pan() - towards));
    }
    EXPECT_LT(most, degrees(4)) << "it looks there, and nowhere else";
    passWith({victim}, 12.0);
    const double before = pan();
    passWith({victim}, 1.0);
    EXPECT_GT(std::abs(pan() - before), degrees(15)) << "nobody is there any more: it looks around again";
}

}  // namespace
}  // namespace leitstand::test
