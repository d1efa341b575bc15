#include "core/robot/robot_description.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/stream_role.h"
#include "core/robot/default_body.h"
#include "core/robot/footprint.h"
#include "core/robot/streams/stream_defaults.h"
#include "core/robot/streams/stream_table.h"

namespace leitstand::test {
namespace {

using Corners = std::vector<Eigen::Vector2d>;

TEST(RobotDescription, HasAWordTypesAndATopicForEveryRole) {
    std::set<std::string> words, topics;
    for (const StreamRole role : allStreamRoles()) {
        const StreamDescription stream =
            defaultStream(role, "kurt3d", streamFacts(role).ofCamera ? toString(role) : "");
        EXPECT_TRUE(words.insert(toString(role)).second) << toString(role);
        EXPECT_TRUE(topics.insert(stream.topic).second) << stream.topic;
        EXPECT_THAT(typesOf(role), testing::Contains(std::string_view(stream.type)));
        const std::string name = toString(role);
        const bool ends =
            name.ends_with("_command") || name.ends_with("_pose") || name == "ping" || name == "stop_lock";
        EXPECT_EQ(isCommand(role), ends) << name;
    }
    EXPECT_EQ(words.size(), allStreamRoles().size());
}

/// What the wire (docs/design.md, "The wire") asks of each topic.
TEST(StreamDefaults, AreThoseOfTheWire) {
    struct Expected {
        StreamRole role;
        const char* topic;
        bool reliable, stays;
        int depth;
        double lifespan;
    };
    const Expected all[] = {
        {StreamRole::Points, "/k/points", true, false, 600, 0.0},
        {StreamRole::Ranges, "/k/scan", false, false, 10, 0.0},
        {StreamRole::Odometry, "/k/odom", false, false, 10, 0.0},
        {StreamRole::Transforms, "/k/tf", false, false, 10, 0.0},
        {StreamRole::StaticTransforms, "/k/tf_static", true, true, 100, 0.0},
        {StreamRole::Picture, "/k/left/image/compressed", false, false, 10, 0.0},
        {StreamRole::CameraInfo, "/k/left/camera_info", false, false, 10, 0.0},
        {StreamRole::Diagnostics, "/diagnostics", false, false, 10, 0.0},
        {StreamRole::Mode, "/k/mode", true, true, 10, 0.0},
        {StreamRole::StopState, "/k/stop_state", true, true, 10, 0.0},
        {StreamRole::Pong, "/k/pong", true, false, 10, 0.0},
        {StreamRole::DriveCommand, "/k/cmd_vel", true, false, 1, 0.2},
        {StreamRole::TrackCommand, "/k/track_cmd", true, false, 1, 0.2},
        {StreamRole::StopCommand, "/k/stop_cmd", true, true, 1, 0.0},
        {StreamRole::ModeCommand, "/k/mode_cmd", true, false, 1, 0.0},
        {StreamRole::PanTiltCommand, "/k/ptu_cmd", true, false, 1, 0.0},
    };
    for (const Expected& one : all) {
        const StreamDescription stream = defaultStream(one.role, "k", "left");
        EXPECT_EQ(stream.topic, one.topic);
        EXPECT_EQ(stream.qos.reliability == Qos::Reliability::Reliable, one.reliable) << one.topic;
        EXPECT_EQ(stream.qos.durability == Qos::Durability::TransientLocal, one.stays) << one.topic;
        EXPECT_EQ(stream.qos.depth, one.depth) << one.topic;
        EXPECT_EQ(stream.qos.lifespan, one.lifespan) << one.topic;
        EXPECT_EQ(stream.qos.deadline, 0.0) << one.topic;
    }
    EXPECT_EQ(defaultStream(StreamRole::Diagnostics, "k", "").hardwareId, "k");
    EXPECT_EQ(defaultStream(StreamRole::StaticTransforms, "k", "", TfPrefix::None).topic, "/tf_static");
}

TEST(Footprint, IsAPolygonWhoseSidesDoNotTouch) {
    EXPECT_EQ(footprintProblem({{0, 0}, {1, 0}, {0, 1}}), "");
    EXPECT_EQ(footprintProblem({{0, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}), "") << "a notch is fine";
    EXPECT_EQ(footprintProblem({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}}), "") << "a corner on a side too";
    EXPECT_NE(footprintProblem({{0, 0}, {2, 2}, {2, 0}, {0, 2}}), "");
    EXPECT_NE(footprintProblem({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}), "") << "a corner touches a side";
    EXPECT_NE(footprintProblem({{0, 0}, {1, 0}, {2, 0}}), "") << "no area";
    EXPECT_NE(footprintProblem(Corners(100, Eigen::Vector2d::Zero())), "");
    EXPECT_DOUBLE_EQ(signedArea({{0, 0}, {2, 0}, {2, 1}, {0, 1}}), 2.0);
    EXPECT_DOUBLE_EQ(signedArea({{0, 1}, {2, 1}, {2, 0}, {0, 0}}), -2.0);
}

TEST(DefaultBody, LeavesWhatIsThere) {
    RobotDescription robot;
    robot.maxSpeed = 2.0;
    robot.baseFrame = "base_footprint";
    fillBody(robot);
    EXPECT_EQ(robot.maxSpeed, 2.0);
    EXPECT_EQ(robot.baseFrame, "base_footprint");
    EXPECT_EQ(robot.odomFrame, "odom");
    EXPECT_EQ(footprintProblem(robot.footprint), "");
    EXPECT_GT(robot.maxTurnRate, 0.0);
}

}  // namespace
}  // namespace leitstand::test
