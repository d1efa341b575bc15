#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/pose.h"
#include "widgets/models/joints/joint_lines.h"
#include "widgets/models/joints/joint_texts.h"

namespace leitstand::test {
namespace {

RobotDescription tracked() {
    RobotDescription robot;
    robot.title = "Tracked";
    robot.height = 0.4;
    robot.footprint = {{0.3, 0.2}, {-0.3, 0.2}, {-0.3, -0.2}, {0.3, -0.2}};
    JointGroup group;
    group.name = "flippers";
    group.title = "Flippers";
    const auto add = [&](const char* name, const JointLink& link) {
        MovedJoint joint;
        joint.name = name;
        joint.lower = degrees(-60);
        joint.upper = degrees(90);
        joint.rate = degrees(40);
        joint.link = link;
        group.joints.push_back(joint);
    };
    add("front_left", {{0.25, 0.1}, 0.3, 0.0, {}});
    add("front_right", {{0.25, 0.1}, 0.3, 0.0, {}});
    add("rear", {{-0.25, 0.1}, 0.3, degrees(180), {}});
    add("hand", {{0.0, 0.0}, 0.2, degrees(90), "rear"});
    group.axes = {{"Front", {0, 1}}, {"Rear", {2}}};
    group.presets = {{"Drive", {0, 0, 0, 0}}};
    robot.jointGroups = {group};
    return robot;
}

TEST(JointLines, FlippersAreRaisedUpwardsInFrontAndBehind) {
    const JointGroup group = tracked().jointGroups[0];
    const auto lines = jointLines(group, {degrees(90), degrees(0), degrees(90), degrees(0)}, 0);
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_LT((lines[0].to - Eigen::Vector2d(0.25, 0.4)).norm(), 1e-9);
    EXPECT_LT((lines[1].to - Eigen::Vector2d(0.55, 0.1)).norm(), 1e-9);
    EXPECT_LT((lines[2].to - Eigen::Vector2d(-0.25, 0.4)).norm(), 1e-9) << "behind, it is raised too";
    EXPECT_LT((lines[3].from - lines[2].to).norm(), 1e-9) << "hangs on the rear one";
    EXPECT_LT((lines[3].to - Eigen::Vector2d(-0.45, 0.4)).norm(), 1e-9) << "square to it";
    EXPECT_TRUE(lines[0].chosen && lines[1].chosen);
    EXPECT_FALSE(lines[2].chosen);
}

TEST(JointLines, WhatIsNotKnownIsNotDrawn) {
    const JointGroup group = tracked().jointGroups[0];
    EXPECT_EQ(jointLines(group, {0.0, std::nullopt, std::nullopt, 0.0}, std::nullopt).size(), 1U)
        << "neither the rear one nor what hangs on it";
    EXPECT_TRUE(jointLines(group, {}, 7).empty());
}

TEST(JointLines, TheDrawingHasRoomForAllThatTheyReach) {
    const RobotDescription robot = tracked();
    for (int front = -60; front <= 90; front += 10) {
        const auto lines =
            jointLines(robot.jointGroups[0], {degrees(front), 0.0, degrees(front), degrees(front)}, 0);
        const SideView reach = reachFromTheSide(robot, lines);
        EXPECT_NEAR(reach.high.x(), 0.55, 1e-9) << "flippers do not change the scale";
        for (const JointLine& line : lines) {
            EXPECT_TRUE((line.to.array() >= reach.low.array() - 1e-9).all() &&
                        (line.to.array() <= reach.high.array() + 1e-9).all());
        }
    }
    EXPECT_NEAR(bodyFromTheSide(robot).high.x(), 0.3, 1e-12);
}

TEST(JointTexts, AnAxisSaysWhereItsJointsAre) {
    JointGroupViews now;
    now["flippers"].positions = {degrees(30), degrees(12), std::nullopt, 0.0};
    const auto rows = jointRows(tracked(), now);
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].title, "Front");
    EXPECT_EQ(rows[0].position, QStringLiteral("30° / 12°"));
    EXPECT_EQ(rows[1].position, QStringLiteral("–"));
    EXPECT_EQ(rows[0].joints,
              QStringLiteral("front_left: 30° (-60° to 90°)\nfront_right: 12° (-60° to 90°)"));
    now["flippers"].positions[1] = degrees(30.2);
    EXPECT_EQ(jointRows(tracked(), now)[0].position, QStringLiteral("30°")) << "they are level";
    EXPECT_EQ(jointRows(tracked(), {})[0].position, QStringLiteral("–"));
}

TEST(JointTexts, TheStatusTellsWhyNothingMoves) {
    const JointGroup group = tracked().jointGroups[0];
    EXPECT_EQ(jointStatus(group, {{}, JointMotion::Still, {}, true}), "");
    EXPECT_EQ(jointStatus(group, {{}, JointMotion::Still, {}, false}), "Flippers: no drive control");
    EXPECT_EQ(jointStatus(group, {{}, JointMotion::ToPreset, 0, true}), "Flippers: to Drive");
    EXPECT_EQ(jointStatus(group, {{}, JointMotion::Blocked, {}, true}), "Flippers: blocked, given up");
    EXPECT_EQ(jointTone({{}, JointMotion::Blocked, {}, true}), Tone::Attention);
    EXPECT_NE(jointStatus(group, {{}, JointMotion::Unreported, {}, true}), "");
}

}  // namespace
}  // namespace leitstand::test
