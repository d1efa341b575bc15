#include "app/services/domain/robot_guess.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/log/replay/replay_rules.h"
#include "core/event/stream_role.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

SeenTopic topic(const std::string& name, const std::string& type, bool written = true) {
    SeenTopic seen;
    seen.name = name;
    seen.type = type;
    seen.written = written;
    seen.read = !written;
    return seen;
}

const TopicVerdict& verdictOn(const RobotGuess& guess, const std::string& name) {
    return *std::find_if(guess.topics.begin(), guess.topics.end(),
                         [&](const TopicVerdict& verdict) { return verdict.topic.name == name; });
}

TEST(RobotGuess, RobotsAreToldByTheirNamespaces) {
    const auto guesses = guessRobots(
        {topic("/kurt3d/odom", "nav_msgs/msg/Odometry"),
         topic("/kurt3d/points", "sensor_msgs/msg/PointCloud2"),
         topic("/kurt3d/left/image/compressed", "sensor_msgs/msg/CompressedImage"),
         topic("/kurt3d/cmd_vel", "geometry_msgs/msg/Twist", false),
         topic("/crawler/odom", "nav_msgs/msg/Odometry"), topic("/tf", "tf2_msgs/msg/TFMessage")});
    ASSERT_EQ(guesses.size(), 2u);
    EXPECT_EQ(guesses[0].robot.name, "crawler");
    EXPECT_EQ(guesses[0].robot.letter, "C");
    const RobotDescription& kurt = guesses[1].robot;
    EXPECT_EQ(kurt.name, "kurt3d");
    EXPECT_EQ(kurt.letter, "K");
    EXPECT_EQ(kurt.tfPrefix, TfPrefix::Frame) << "both share /tf";
    ASSERT_NE(kurt.stream(StreamRole::DriveCommand), nullptr);
    ASSERT_NE(kurt.stream(StreamRole::Picture, "left"), nullptr);
    ASSERT_NE(kurt.stream(StreamRole::Transforms), nullptr);
    EXPECT_EQ(kurt.stream(StreamRole::Points)->qos.depth, 600) << "DDS does not tell it: a radio gap of 60 s";
}

TEST(RobotGuess, ATreeOfItsOwnIsTakenBeforeTheOneThatAllShare) {
    const auto guesses = guessRobots(
        {topic("/tf", "tf2_msgs/msg/TFMessage"), topic("/tf_static", "tf2_msgs/msg/TFMessage"),
         topic("/diagnostics", "diagnostic_msgs/msg/DiagnosticArray"),
         topic("/kurt3d/odom", "nav_msgs/msg/Odometry"), topic("/kurt3d/tf", "tf2_msgs/msg/TFMessage"),
         topic("/kurt3d/tf_static", "tf2_msgs/msg/TFMessage"),
         topic("/crawler/odom", "nav_msgs/msg/Odometry")});
    ASSERT_EQ(guesses.size(), 2u);
    const RobotDescription &crawler = guesses[0].robot, &kurt = guesses[1].robot;
    EXPECT_EQ(kurt.tfPrefix, TfPrefix::Topic);
    EXPECT_EQ(kurt.stream(StreamRole::StaticTransforms)->topic, "/kurt3d/tf_static");
    EXPECT_EQ(crawler.tfPrefix, TfPrefix::Frame);
    EXPECT_EQ(crawler.stream(StreamRole::StaticTransforms)->topic, "/tf_static");
    EXPECT_NE(kurt.stream(StreamRole::Diagnostics), nullptr);
}

TEST(RobotGuess, SharedDiagnosticsSayNothingOfFrames) {
    const auto guesses = guessRobots({topic("/diagnostics", "diagnostic_msgs/msg/DiagnosticArray"),
                                      topic("/kurt3d/odom", "nav_msgs/msg/Odometry"),
                                      topic("/crawler/odom", "nav_msgs/msg/Odometry")});
    ASSERT_EQ(guesses.size(), 2u);
    EXPECT_EQ(guesses[0].robot.tfPrefix, TfPrefix::Topic);
    EXPECT_EQ(guesses[1].robot.tfPrefix, TfPrefix::Topic);
    EXPECT_EQ(guesses[0].robot.stream(StreamRole::Diagnostics)->hardwareId, "crawler");
    EXPECT_EQ(guesses[1].robot.stream(StreamRole::Diagnostics)->hardwareId, "kurt3d")
        << "they share the topic";
}

TEST(RobotGuess, AStockRobotWithoutANamespaceIsOneRobot) {
    const auto guesses =
        guessRobots({topic("/odom", "nav_msgs/msg/Odometry"), topic("/scan", "sensor_msgs/msg/LaserScan"),
                     topic("/camera/image_raw", "sensor_msgs/msg/Image"),
                     topic("/cmd_vel", "geometry_msgs/msg/Twist", false)});
    ASSERT_EQ(guesses.size(), 1u);
    EXPECT_EQ(guesses[0].robot.name, "robot");
    EXPECT_EQ(guesses[0].robot.tfPrefix, TfPrefix::None);
    EXPECT_NE(guesses[0].robot.stream(StreamRole::Picture, "camera"), nullptr);
}

TEST(RobotGuess, TellsWhyATopicIsOfNoUse) {
    const auto guesses =
        guessRobots({topic("/r/odom", "nav_msgs/msg/Odometry"), topic("/r/odom2", "nav_msgs/msg/Odometry"),
                     topic("/r/depth/compressedDepth", "sensor_msgs/msg/CompressedImage"),
                     topic("/r/secret", "their_msgs/msg/Thing"), topic("rq/r/setRequest", "x"),
                     topic("/r/cmd_vel", "geometry_msgs/msg/Twist")});
    ASSERT_EQ(guesses.size(), 1u);
    EXPECT_THAT(verdictOn(guesses[0], "/r/odom2").remark, HasSubstr("/r/odom"));
    EXPECT_THAT(verdictOn(guesses[0], "/r/depth/compressedDepth").remark, HasSubstr("compressedDepth"));
    EXPECT_THAT(verdictOn(guesses[0], "/r/secret").remark, HasSubstr("their_msgs/msg/Thing"));
    EXPECT_THAT(verdictOn(guesses[0], "rq/r/setRequest").remark, HasSubstr("service"));
    EXPECT_THAT(verdictOn(guesses[0], "/r/cmd_vel").remark, HasSubstr("nobody listens"));
}

TEST(RobotGuess, LettersDiffer) {
    const auto guesses = guessRobots({topic("/kurt/odom", "nav_msgs/msg/Odometry"),
                                      topic("/karl/odom", "nav_msgs/msg/Odometry"),
                                      topic("/k/odom", "nav_msgs/msg/Odometry")});
    ASSERT_EQ(guesses.size(), 3u);
    EXPECT_NE(guesses[0].robot.letter, guesses[1].robot.letter);
    EXPECT_NE(guesses[1].robot.letter, guesses[2].robot.letter);
    EXPECT_NE(guesses[0].robot.letter, guesses[2].robot.letter);
}

TEST(ReplayRules, NeverWhatMovesARobotOrSpeaksForAStation) {
    EXPECT_TRUE(isReplayable("/kurt3d/points", "sensor_msgs/msg/PointCloud2"));
    EXPECT_TRUE(isReplayable("/kurt3d/stop_state", "leitstand_msgs/msg/StopState"));
    EXPECT_TRUE(isReplayable("/kurt3d/joint_states", "sensor_msgs/msg/JointState"));
    EXPECT_FALSE(isReplayable("/kurt3d/cmd_vel", "geometry_msgs/msg/Twist"));
    EXPECT_FALSE(isReplayable("/base/velocity", "geometry_msgs/msg/TwistStamped")) << "by its type";
    EXPECT_FALSE(isReplayable("/kurt3d/track_cmd", "sensor_msgs/msg/JointState"));
    EXPECT_FALSE(isReplayable("/kurt3d/goal_pose", "geometry_msgs/msg/PoseStamped"));
    EXPECT_FALSE(isReplayable("/kurt3d/stop_cmd", "leitstand_msgs/msg/StopCommand"));
    EXPECT_FALSE(isReplayable("/kurt3d/ping", "leitstand_msgs/msg/Ping"));
    EXPECT_FALSE(isReplayable("/leitstand/grants", "leitstand_msgs/msg/Grant"));
    EXPECT_FALSE(isReplayable("/arm/commands", "std_msgs/msg/Float64MultiArray"));
}

TEST(ReplayRules, RobotsAreToldByTheirNamespaces) {
    EXPECT_EQ(robotOfTopic("/kurt3d/odom"), "kurt3d");
    EXPECT_EQ(robotOfTopic("/odom"), "");
    EXPECT_EQ(robotOfTopic("rq/x"), "");
}

}  // namespace
}  // namespace leitstand::test
