#include "robots/crawler/crawler_agent.h"

#include <gtest/gtest.h>

#include "core/io/robot/robot_file.h"
#include "tests/support/fake_robot.h"

namespace leitstand::test {
namespace {

struct Crawler : testing::Test {
    FakeRobot robot;
    CrawlerAgent agent{robot, readRobot(LEITSTAND_SOURCE_DIR "/resources/robots/crawler.yaml").value()};
    FakeStation<CrawlerAgent> station{robot, agent, "crawler"};
};

JointSample tracks(double left, double right) {
    JointSample command;
    command.names = {"left_track", "right_track"};
    command.velocities = {left, right};
    return command;
}

TEST_F(Crawler, EachChainKeepsItsSpeed) {
    station.hold();
    station.say(StreamRole::TrackCommand, tracks(0.0, 0.0));
    for (int i = 0; i < 20; ++i) {
        station.say(StreamRole::TrackCommand, tracks(0.2, 0.1));
        station.pass(0.05);
    }
    EXPECT_NEAR(robot.tracks().left, 0.2, 0.02);
    EXPECT_NEAR(robot.tracks().right, 0.1, 0.02);
}

TEST_F(Crawler, TheRadioRemoteGoesBeforeTheStationAndIsSeen) {
    station.keepDriving(0.0, 0.1);
    station.keepDriving(0.3, 0.5);
    EXPECT_GT(robot.left, 0.2);
    TwistSample back;
    back.linear.x() = -0.2;
    robot.radio = back;
    station.keepDriving(0.3, 0.5);
    EXPECT_LT(robot.left, -0.2);
    EXPECT_EQ(agent.mode(), DriveMode::Remote);
    EXPECT_EQ(station.all<ModeSample>().back().mode, "remote");
    robot.radio.reset();
    station.keepDriving(0.3, 1.5);
    EXPECT_EQ(agent.mode(), DriveMode::Teleoperation);
    EXPECT_EQ(robot.left, 0.0) << "the station's sticks must be neutral first";
}

TEST_F(Crawler, AStopHoldsAgainstTheRemoteToo) {
    TwistSample ahead;
    ahead.linear.x() = 0.2;
    robot.radio = ahead;
    station.pass(0.5);
    EXPECT_GT(robot.left, 0.1);
    station.stop(1);
    station.pass(0.5);
    EXPECT_EQ(robot.left, 0.0);
    EXPECT_TRUE(robot.brake);
}

TEST_F(Crawler, WarnsBeforeItRollsOver) {
    ImuSample imu;
    imu.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX()));
    imu.header.stamp = robot.time;
    robot.samples.push_back({StreamRole::Imu, "imu", imu});
    station.pass(0.01);
    const auto warnings = station.all<DiagnosticsSample>();
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].statuses[0].level, DiagnosticStatus::Level::Warning);
    EXPECT_EQ(warnings[0].statuses[0].hardwareId, "crawler");
}

}  // namespace
}  // namespace leitstand::test
