#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/event/stream_role.h"
#include "core/io/robot/robot_file.h"
#include "core/io/robot/shipped_robots.h"
#include "core/robot/team.h"
#include "tests/io/robot/robot_texts.h"

namespace leitstand::test {
namespace {

RobotDescription shipped(const std::string& name) {
    auto robot = readRobot(ShippedRobots / (name + ".yaml"));
    EXPECT_TRUE(robot) << robot.error().text;
    return robot ? std::move(robot).value() : RobotDescription{};
}

TEST(ShippedRobots, AreWholeAndGetOnWithEachOther) {
    std::vector<RobotDescription> all;
    for (const std::string& name : shippedRobots({ShippedRobots})) all.push_back(shipped(name));
    EXPECT_GE(all.size(), 5U);
    std::set<std::string> letters;
    for (const RobotDescription& robot : all) {
        EXPECT_TRUE(letters.insert(robot.letter).second) << robot.name << ": another one has its letter";
        EXPECT_NE(robot.stream(StreamRole::Odometry), nullptr) << robot.name;
        EXPECT_NE(robot.stream(StreamRole::DriveCommand), nullptr) << robot.name;
        EXPECT_GT(robot.maxSpeed, 0.0);
        for (const StreamDescription& stream : robot.streams) {
            EXPECT_TRUE(stream.sensor.empty() || robot.sensors.contains(stream.sensor)) << stream.topic;
        }
    }
    // Beside ours; two stock robots without a namespace would use the same topics.
    for (const RobotDescription& robot : all) {
        std::vector<RobotDescription> team = {shipped("kurt3d"), shipped("crawler")};
        if (robot.name != "kurt3d" && robot.name != "crawler") team.push_back(robot);
        const auto works = checkTeam(team);
        EXPECT_TRUE(works) << robot.name << ": " << works.error().text;
    }
}

TEST(ShippedRobots, SpeakTheTopicsOfTheDesign) {
    const RobotDescription kurt = shipped("kurt3d");
    ASSERT_NE(kurt.stream(StreamRole::Points), nullptr);
    EXPECT_EQ(kurt.stream(StreamRole::Points)->qos.depth, 600);
    EXPECT_EQ(kurt.stream(StreamRole::StopCommand)->qos.lifespan, 0.0);
    EXPECT_EQ(kurt.stream(StreamRole::DriveCommand)->qos.lifespan, 0.2);
    EXPECT_EQ(kurt.stream(StreamRole::Thermal)->sensor, "ir");
    EXPECT_EQ(kurt.linkLoss.at("explore"), LinkLossRule::ReturnToLink);
    EXPECT_EQ(shipped("crawler").drive, DriveType::Tracked);
    EXPECT_EQ(shipped("turtlebot").tfPrefix, TfPrefix::None);
}

TEST(ShippedRobots, AreWrittenAsTheyAreRead) {
    for (const std::string& name : shippedRobots({ShippedRobots})) {
        const RobotDescription robot = shipped(name);
        const auto again = parseRobot(writeRobot(robot), name);
        ASSERT_TRUE(again) << again.error().text;
        EXPECT_EQ(writeRobot(*again), writeRobot(robot));
        EXPECT_EQ(again->streams.size(), robot.streams.size());
    }
}

}  // namespace
}  // namespace leitstand::test
