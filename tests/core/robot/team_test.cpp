#include "core/robot/team.h"

#include <gtest/gtest.h>

#include "core/event/stream_role.h"
#include "core/robot/streams/stream_defaults.h"

namespace leitstand::test {
namespace {

RobotDescription robotWith(const std::string& name, const std::string& letter,
                           std::initializer_list<StreamRole> roles = {}) {
    RobotDescription robot;
    robot.name = name;
    robot.letter = letter;
    for (const StreamRole role : roles) robot.streams.push_back(defaultStream(role, name, {}));
    return robot;
}

std::string clashesOf(const RobotDescription& a, const RobotDescription& b) {
    const RobotDescription both[] = {a, b};
    const auto result = checkTeam(both);
    return result.ok() ? std::string() : result.error().text;
}

TEST(Team, WorksWhenNothingIsShared) {
    EXPECT_EQ(clashesOf(robotWith("a", "A", {StreamRole::Points, StreamRole::DriveCommand}),
                        robotWith("b", "B", {StreamRole::Points, StreamRole::DriveCommand})),
              "");
    EXPECT_TRUE(checkTeam({}).ok());
}

TEST(Team, TellsNamesAndLettersThatAreThereTwice) {
    EXPECT_EQ(clashesOf(robotWith("a", "A", {StreamRole::Points}), robotWith("a", "B", {StreamRole::Points})),
              "two robots are named a: expected a name of its own for each")
        << "and nothing of the topics";
    EXPECT_EQ(clashesOf(robotWith("a", "A"), robotWith("b", "A")),
              "a and b both have the letter A: expected one of its own for each");
}

TEST(Team, TellsSharedTopicsAndWhatToDo) {
    RobotDescription a = robotWith("a", "A", {StreamRole::Odometry, StreamRole::DriveCommand});
    RobotDescription b = robotWith("b", "B", {StreamRole::Odometry, StreamRole::DriveCommand});
    for (RobotDescription* robot : {&a, &b}) {
        robot->streams[0].topic = "/odom";
        robot->streams[1].topic = "/cmd_vel";
    }
    EXPECT_EQ(clashesOf(a, b),
              "a and b share the topic /odom: give each a topic of its own\n"
              "a and b share the topic /cmd_vel: both would obey the same command");
}

TEST(Team, SharesTransformsWhenFramesTellWhose) {
    RobotDescription a = robotWith("a", "A"), b = robotWith("b", "B");
    for (RobotDescription* robot : {&a, &b}) {
        robot->streams.push_back(defaultStream(StreamRole::Transforms, robot->name, {}, TfPrefix::Frame));
        robot->tfPrefix = TfPrefix::Frame;
    }
    EXPECT_EQ(clashesOf(a, b), "");
    b.tfPrefix = TfPrefix::None;
    EXPECT_EQ(clashesOf(a, b),
              "a and b share the topic /tf: give each a topic of its own, or frames that begin with its name "
              "and frames.prefix: frame");
}

TEST(Team, SharesDiagnosticsWhenHardwareTellsWhose) {
    RobotDescription a = robotWith("a", "A", {StreamRole::Diagnostics});
    RobotDescription b = robotWith("b", "B", {StreamRole::Diagnostics});
    EXPECT_EQ(clashesOf(a, b), "");
    for (const char* id : {"", "a", "a/laser"}) {
        b.streams[0].hardwareId = id;
        EXPECT_EQ(clashesOf(a, b), "a and b share the topic /diagnostics: tell them apart by hardware_id")
            << id;
    }
}

}  // namespace
}  // namespace leitstand::test
