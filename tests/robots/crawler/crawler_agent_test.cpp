#include "robots/crawler/crawler_agent.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/cloud_sample.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "core/io/robot/robot_file.h"
#include "robots/control/fuzzy/fuzzy_file.h"
#include "tests/support/fake_robot.h"
#include "tests/support/places.h"

namespace leitstand::test {
namespace {

std::unique_ptr<CrawlerAgent> agentOf(FakeRobot& robot) {
    const std::string resources = sourceFolder() + "/resources/";
    return CrawlerAgent::create(robot, readRobot(resources + "robots/crawler.yaml").value(),
                                readFuzzySystem(resources + "control/fuzzy_drive.yaml").value())
        .value();
}

struct Crawler : testing::Test {
    FakeRobot robot;
    std::unique_ptr<CrawlerAgent> owned = agentOf(robot);
    CrawlerAgent& agent = *owned;
    FakeStation<CrawlerAgent> station{robot, agent, "crawler"};
    double roll = 0.0;  ///< [rad]

    /// A turn of its laser in a hall without walls, or with one so far ahead [m].
    void look(double wall = std::numeric_limits<double>::infinity()) {
        RangesSample ranges;
        ranges.header = {robot.time, "laser"};
        ranges.angleMin = degrees(-119.88);
        ranges.angleStep = degrees(0.36);
        ranges.rangeMin = 0.06;
        ranges.rangeMax = 4.0;
        for (int i = 0; i < 667; ++i) {
            const double angle = ranges.angleMin + i * ranges.angleStep;
            const double away = std::cos(angle) > 0.1 ? wall / std::cos(angle) : 9.0;
            ranges.ranges.push_back(
                static_cast<float>(away < 4.0 ? away : std::numeric_limits<double>::infinity()));
        }
        robot.samples.push_back({StreamRole::Ranges, "laser", ranges});
        ImuSample imu;
        imu.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()));
        imu.header.stamp = robot.time;
        robot.samples.push_back({StreamRole::Imu, "imu", imu});
    }
    /// Time passes while it sees; the fastest that its chains went, backwards at the most.
    double pass(double seconds, double wall = std::numeric_limits<double>::infinity()) {
        double slowest = 1.0;
        for (int i = 0; i < static_cast<int>(10.0 * seconds + 0.5); ++i) {
            if (i % 10 == 0) station.hold();
            look(wall);
            station.pass(0.1);
            slowest = std::min(slowest, 0.5 * (robot.leftSpeed + robot.rightSpeed));
        }
        return slowest;
    }
    void bump(const char* side, std::uint32_t hits) {
        BumpSample bumps;
        bumps.header.stamp = robot.time;
        bumps.bumpers = {{side, true, hits}};
        robot.samples.push_back({StreamRole::Bumps, {}, bumps});
    }
    [[nodiscard]] std::string reason() const { return station.all<ModeSample>().back().reason; }
};

JointSample tracks(double left, double right) {
    JointSample command;
    command.names = {"left_track", "right_track"};
    command.velocities = {left, right};
    return command;
}

TEST_F(Crawler, EachChainKeepsItsSpeed) {
    station.hold();
    station.publish(StreamRole::TrackCommand, tracks(0.0, 0.0));
    for (int i = 0; i < 20; ++i) {
        station.publish(StreamRole::TrackCommand, tracks(0.2, 0.1));
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

TEST_F(Crawler, OffersToBeDrivenSafelyAndToExplore) {
    pass(0.5);
    EXPECT_THAT(station.all<ModeSample>().back().available,
                testing::ElementsAre("teleoperation", "safe_teleoperation", "explore"));
    station.mode("victim_approach");
    pass(0.1);
    EXPECT_EQ(agent.mode(), DriveMode::Teleoperation);
}

TEST_F(Crawler, ExploresAndStopsWhenItIsTold) {
    station.hold();
    station.mode("explore");
    pass(4.0);
    EXPECT_EQ(agent.mode(), DriveMode::Explore);
    EXPECT_TRUE(station.all<ModeSample>().back().autonomous);
    EXPECT_GT(std::abs(robot.leftSpeed) + std::abs(robot.rightSpeed), 0.02);
    station.stop(1);
    pass(0.3);
    EXPECT_TRUE(robot.brake);
    EXPECT_EQ(agent.mode(), DriveMode::Stopped);
    station.stop(2, false, station.all<StopStateSample>().back().stops);
    pass(1.0);
    EXPECT_EQ(agent.mode(), DriveMode::Teleoperation) << "released into its operator's hands";
    EXPECT_TRUE(robot.brake);
}

TEST_F(Crawler, WithoutItsLaserItStands) {
    station.hold();
    station.mode("explore");
    pass(3.0);
    for (int i = 0; i < 20; ++i) {
        station.hold();
        station.pass(0.1);
    }
    EXPECT_EQ(agent.mode(), DriveMode::Explore);
    EXPECT_TRUE(robot.brake);
}

TEST_F(Crawler, BacksOutOfWhatItRanAgainst) {
    station.hold();
    station.mode("explore");
    pass(3.0);
    bump("front", 1);
    EXPECT_LT(pass(1.0), -0.08);
    EXPECT_EQ(agent.mode(), DriveMode::Explore);
}

TEST_F(Crawler, ABumpUnderItsOperatorsHandsIsHisAffair) {
    station.keepDriving(0.0, 0.1);
    station.keepDriving(0.2, 0.3);
    bump("front", 1);
    station.keepDriving(0.2, 0.5);
    EXPECT_GT(robot.leftSpeed, 0.15);
    station.mode("explore");
    EXPECT_GT(pass(1.0), -0.02) << "nor is it run away from later";
}

TEST_F(Crawler, BacksOutWhenItLeansTooMuchAndGivesUpWhenThatDoesNotHelp) {
    station.hold();
    station.mode("explore");
    pass(3.0);
    roll = degrees(20);  // of 35
    EXPECT_LT(pass(1.0), -0.08);
    pass(40.0);
    EXPECT_TRUE(robot.brake);
    EXPECT_EQ(agent.mode(), DriveMode::Explore);
    EXPECT_THAT(reason(), testing::HasSubstr("finds no way off"));
}

TEST_F(Crawler, LeaningASlowerSafeTeleoperation) {
    station.keepDriving(0.0, 0.1);
    station.mode("safe_teleoperation");
    const auto drive = [&] {
        for (int i = 0; i < 20; ++i) {
            look();
            station.keepDriving(i == 0 ? 0.0 : 0.3, 0.1);
        }
        return robot.leftSpeed;
    };
    EXPECT_NEAR(drive(), 0.3, 0.03);
    roll = degrees(17);
    EXPECT_LT(drive(), 0.2);
    EXPECT_GT(drive(), 0.05);
}

TEST_F(Crawler, SafeTeleoperationStopsBeforeWhatItsLaserSees) {
    station.keepDriving(0.0, 0.1);
    station.mode("safe_teleoperation");
    for (int i = 0; i < 20; ++i) {
        look(0.16);  // 0.30 m from its middle, 0.10 from its front
        station.keepDriving(i == 0 ? 0.0 : 0.3, 0.1);
    }
    EXPECT_LT(robot.leftSpeed, 0.06);
}

}  // namespace
}  // namespace leitstand::test
