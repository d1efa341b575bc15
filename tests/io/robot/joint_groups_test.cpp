// Flippers and arms in robots' files.
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/pose.h"
#include "core/event/stream_role.h"
#include "core/io/robot/robot_file.h"
#include "tests/io/robot/robot_texts.h"

namespace leitstand::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string Command = "  - {role: joint_command, group: arm, topic: /arm/joint_trajectory}\n";
const std::string Joints =
    "    joints:\n"
    "      - {name: lift, type: prismatic, lower: 0, upper: 0.4, rate: 0.1}\n"
    "      - {name: elbow, lower: -90, upper: 45, rate: 30, reversed: true, "
    "link: {at: [0.1, 0.2], length: 0.5, zero: 90, parent: lift}}\n"
    "      - {name: hand-roll}\n";

std::string with(const std::string& group, const std::string& streams = Command) {
    return Head + "streams:\n" + streams + "joint_groups:\n  - name: arm\n" + group;
}

std::string errorOf(const std::string& text) {
    const auto robot = parseRobot(text, "r.yaml");
    EXPECT_FALSE(robot.ok()) << text;
    return robot.ok() ? std::string() : robot.error().text;
}

TEST(JointGroups, AreReadInTheProgramsUnits) {
    const auto read = parseRobot(with("    title: Arm\n    command: position\n" + Joints +
                                      "    axes:\n      - {title: Elbow, joints: [elbow]}\n"
                                      "    presets:\n      - {title: Up, positions: [0.2, 45, 180]}\n"),
                                 "r.yaml");
    ASSERT_TRUE(read) << read.error().text;
    ASSERT_EQ(read->jointGroups.size(), 1U);
    const JointGroup& arm = read->jointGroups[0];
    EXPECT_EQ(arm.title, "Arm");
    ASSERT_EQ(arm.joints.size(), 3U);
    EXPECT_EQ(arm.joints[0].type, JointType::Prismatic);
    EXPECT_EQ(arm.joints[0].upper, 0.4);
    EXPECT_EQ(arm.joints[0].rate, 0.1);
    EXPECT_NEAR(*arm.joints[1].lower, degrees(-90), 1e-12);
    EXPECT_TRUE(arm.joints[1].reversed);
    EXPECT_NEAR(arm.joints[1].link->zero, degrees(90), 1e-12);
    EXPECT_EQ(arm.joints[1].link->parent, "lift");
    EXPECT_EQ(arm.joints[2].upper, std::nullopt);
    EXPECT_NEAR(arm.joints[2].rate, degrees(45), 1e-12) << "the usual one";
    EXPECT_EQ(arm.axes, (std::vector<JointAxis>{{"Elbow", {1}}}));
    EXPECT_THAT(arm.presets[0].positions, ElementsAre(0.2, testing::DoubleNear(degrees(45), 1e-12),
                                                      testing::DoubleNear(degrees(180), 1e-12)));
    const StreamDescription* const commands = read->commandsOf(arm);
    ASSERT_NE(commands, nullptr);
    EXPECT_EQ(commands->type, "trajectory_msgs/msg/JointTrajectory");
    EXPECT_EQ(commands->qos.lifespan, 0.2);
}

TEST(JointGroups, AreWrittenAsTheyAreRead) {
    const auto read =
        parseRobot(with(Joints + "    presets:\n      - {title: Up, positions: [0.2, 45, 180]}\n"), "r.yaml");
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(read->jointGroups[0].axes.size(), 3U) << "each joint by itself";
    const auto again = parseRobot(writeRobot(*read), "again.yaml");
    ASSERT_TRUE(again) << again.error().text << writeRobot(*read);
    EXPECT_EQ(again->jointGroups, read->jointGroups);
    EXPECT_EQ(again->streams, read->streams);
}

TEST(JointGroups, MistakesAreToldWithTheirPlace) {
    EXPECT_THAT(errorOf(with("    joints: []\n")),
                HasSubstr("r.yaml:7: joint_groups[0].joints: expected a list of joints, found none"));
    EXPECT_THAT(errorOf(with("    joints: [{name: a}, {name: a}]\n")),
                HasSubstr("expected each joint once, found \"a\" again"));
    EXPECT_THAT(errorOf(with("    joints: [{name: a, lower: 10, upper: 5}]\n")),
                HasSubstr("expected less than upper, 5 degrees, found 10"));
    EXPECT_THAT(errorOf(with("    joints: [{name: a, type: prismatic}]\n")),
                HasSubstr("lower and upper of a prismatic"));
    EXPECT_THAT(errorOf(with("    joints: [{name: a, type: screw}]\n")), HasSubstr("revolute or prismatic"));
    EXPECT_THAT(errorOf(with("    joints: [{name: a, rate: .nan}]\n")), HasSubstr("rate: expected"));
    EXPECT_THAT(errorOf(with("    joints: [{name: a, link: {parent: b}}]\n")),
                testing::AllOf(HasSubstr("length: expected how long it is"),
                               HasSubstr("stands before it, found \"b\"")));
    EXPECT_THAT(errorOf(with(Joints + "    axes: [{joints: [lift, lift]}]\n")),
                HasSubstr("each once, found \"lift\""));
    EXPECT_THAT(errorOf(with(Joints + "    presets: [{title: Up, positions: [0, 0]}]\n")),
                HasSubstr("positions: expected"));
    EXPECT_THAT(errorOf(with(Joints + "    presets: [{title: Up, positions: [0.5, 0, 0]}]\n")),
                HasSubstr("expected lift within its limits, found 0.5"));
    EXPECT_THAT(errorOf(with(Joints + "    command: force\n")), HasSubstr("position or velocity"));
    EXPECT_THAT(errorOf(with(Joints + "    command: velocity\n")),
                HasSubstr("expected positions in a JointTrajectory"));
    std::string many = "    joints:\n";
    for (int i = 0; i < 40; ++i) many += fmt::format("      - {{name: j{}}}\n", i);
    EXPECT_THAT(errorOf(with(many)), HasSubstr("expected at most 32, found 40"));
}

TEST(JointGroups, EachHasOneStreamThatCommandsIt) {
    EXPECT_THAT(errorOf(with(Joints, "  - {role: odometry}\n")),
                HasSubstr("expected a stream joint_command with the group \"arm\", found none"));
    EXPECT_THAT(errorOf(with(Joints, "  - {role: joint_command}\n")),
                HasSubstr("expected the name of one of joint_groups, found nothing"));
    EXPECT_THAT(errorOf(with(Joints, Command + "  - {role: joint_command, group: legs, topic: /legs}\n")),
                HasSubstr("found \"legs\""));
    EXPECT_THAT(errorOf(with(Joints, Command + "  - {role: joint_command, group: arm, topic: /arm2}\n")),
                HasSubstr("expected one stream for each group"));
    EXPECT_THAT(errorOf(with(Joints, Command + "  - {role: odometry, group: arm}\n")),
                HasSubstr("expected it only for joint_command"));
}

}  // namespace
}  // namespace leitstand::test
