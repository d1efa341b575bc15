#include "app/services/domain/robot_guess.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/domain/model_watch.h"
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
                     topic("/r/front/image_raw/theora", "sensor_msgs/msg/CompressedImage"),
                     topic("/r/secret", "their_msgs/msg/Thing"), topic("rq/r/setRequest", "x"),
                     topic("/r/cmd_vel", "geometry_msgs/msg/Twist")});
    ASSERT_EQ(guesses.size(), 1u);
    EXPECT_THAT(verdictOn(guesses[0], "/r/odom2").remark, HasSubstr("/r/odom"));
    EXPECT_THAT(verdictOn(guesses[0], "/r/front/image_raw/theora").remark, HasSubstr("theora"));
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

/// What @p guess takes as @p role; empty: nothing.
std::string topicOf(const RobotGuess& guess, StreamRole role, const std::string& sensor = {}) {
    const StreamDescription* const stream = guess.robot.stream(role, sensor);
    return stream == nullptr ? std::string() : stream->topic;
}

// Names and types as the drivers' sources have them: turtlebot4_bringup and irobot_create_msgs (Humble),
// clearpath_robot (Humble), ouster-ros (ros2), livox_ros_driver2, depthai-ros, nav2_bringup.
std::vector<SeenTopic> turtlebot4(const std::string& space) {
    std::vector<SeenTopic> topics = {
        topic(space + "/odom", "nav_msgs/msg/Odometry"),
        topic(space + "/imu", "sensor_msgs/msg/Imu"),
        topic(space + "/scan", "sensor_msgs/msg/LaserScan"),
        topic(space + "/battery_state", "sensor_msgs/msg/BatteryState"),
        topic(space + "/joint_states", "sensor_msgs/msg/JointState"),
        topic(space + "/diagnostics", "diagnostic_msgs/msg/DiagnosticArray"),
        topic(space + "/oakd/rgb/preview/image_raw", "sensor_msgs/msg/Image"),
        topic(space + "/oakd/rgb/preview/image_raw/compressed", "sensor_msgs/msg/CompressedImage"),
        topic(space + "/oakd/rgb/preview/image_raw/compressedDepth", "sensor_msgs/msg/CompressedImage"),
        topic(space + "/oakd/rgb/preview/camera_info", "sensor_msgs/msg/CameraInfo"),
        topic(space + "/oakd/stereo/image_raw", "sensor_msgs/msg/Image"),
        topic(space + "/oakd/imu/data", "sensor_msgs/msg/Imu"),
        topic(space + "/cmd_vel", "geometry_msgs/msg/TwistStamped", false),
        topic(space + "/diffdrive_controller/cmd_vel", "geometry_msgs/msg/TwistStamped", false),
        topic(space + "/diffdrive_controller/odom", "nav_msgs/msg/Odometry"),
        topic(space + "/tf", "tf2_msgs/msg/TFMessage"),
        topic(space + "/tf_static", "tf2_msgs/msg/TFMessage"),
        topic(space + "/dock_status", "irobot_create_msgs/msg/DockStatus")};
    topics.back().read = false;
    return topics;
}

std::vector<SeenTopic> sensorsWithNamespaces() {
    return {topic("/ouster/points", "sensor_msgs/msg/PointCloud2"),
            topic("/ouster/imu", "sensor_msgs/msg/Imu"),
            topic("/ouster/scan", "sensor_msgs/msg/LaserScan"),
            topic("/livox/lidar", "sensor_msgs/msg/PointCloud2"),
            topic("/livox/imu", "sensor_msgs/msg/Imu"),
            topic("/camera/odom/sample", "nav_msgs/msg/Odometry")};
}

std::vector<SeenTopic> operator+(std::vector<SeenTopic> a, const std::vector<SeenTopic>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

TEST(RobotGuess, DriversOfSensorsAreNoRobots) {
    const auto guesses = guessRobots(turtlebot4("") + sensorsWithNamespaces());
    ASSERT_EQ(guesses.size(), 1U);
    const RobotGuess& robot = guesses[0];
    EXPECT_EQ(robot.robot.name, "robot");
    EXPECT_EQ(topicOf(robot, StreamRole::DriveCommand), "/cmd_vel");
    EXPECT_EQ(topicOf(robot, StreamRole::Odometry), "/odom");
    EXPECT_EQ(topicOf(robot, StreamRole::Transforms), "/tf");
    EXPECT_EQ(topicOf(robot, StreamRole::Imu), "/imu");
    EXPECT_NE(topicOf(robot, StreamRole::Points), "");
}

TEST(RobotGuess, ASensorWithANamespaceIsOfTheOnlyRobot) {
    const auto guesses = guessRobots(turtlebot4("/tb4") + sensorsWithNamespaces());
    ASSERT_EQ(guesses.size(), 1U);
    EXPECT_EQ(guesses[0].robot.name, "tb4");
    EXPECT_EQ(guesses[0].robot.tfPrefix, TfPrefix::Topic);
    EXPECT_EQ(topicOf(guesses[0], StreamRole::DriveCommand), "/tb4/cmd_vel");
    EXPECT_EQ(topicOf(guesses[0], StreamRole::Odometry), "/tb4/odom");
    EXPECT_NE(topicOf(guesses[0], StreamRole::Points), "");
}

TEST(RobotGuess, RobotsOfOneKindAndOneWithoutANamespaceAreToldApart) {
    const auto guesses = guessRobots(turtlebot4("") + turtlebot4("/tb1") + turtlebot4("/tb2"));
    ASSERT_EQ(guesses.size(), 3U);
    EXPECT_EQ(topicOf(guesses[0], StreamRole::Odometry), "/odom");
    EXPECT_EQ(topicOf(guesses[1], StreamRole::Odometry), "/tb1/odom");
    EXPECT_EQ(topicOf(guesses[2], StreamRole::DriveCommand), "/tb2/cmd_vel");
    EXPECT_EQ(topicOf(guesses[2], StreamRole::Transforms), "/tb2/tf");
}

TEST(RobotGuess, TopicsInDepthAreOfTheNamespaceAboveThem) {
    const auto guesses =
        guessRobots({topic("/a200_0000/platform/odom/filtered", "nav_msgs/msg/Odometry"),
                     topic("/a200_0000/platform/cmd_vel_unstamped", "geometry_msgs/msg/Twist", false),
                     topic("/a200_0000/tf", "tf2_msgs/msg/TFMessage"),
                     topic("/a200_0000/sensors/lidar3d_0/points", "sensor_msgs/msg/PointCloud2"),
                     topic("/a200_0000/sensors/camera_0/color/image", "sensor_msgs/msg/Image")});
    ASSERT_EQ(guesses.size(), 1U);
    EXPECT_EQ(guesses[0].robot.name, "a200_0000");
    EXPECT_EQ(topicOf(guesses[0], StreamRole::Points), "/a200_0000/sensors/lidar3d_0/points");
    EXPECT_EQ(topicOf(guesses[0], StreamRole::DriveCommand), "/a200_0000/platform/cmd_vel_unstamped");
    EXPECT_EQ(topicOf(guesses[0], StreamRole::Picture, "sensors_camera_0_color"),
              "/a200_0000/sensors/camera_0/color/image");
}

TEST(RobotGuess, WhatIsPrivateToANodeIsNoNamespace) {
    SeenTopic command = topic("/base_driver/cmd_vel", "geometry_msgs/msg/Twist", false);
    SeenTopic odometry = topic("/base_driver/odom", "nav_msgs/msg/Odometry");
    EXPECT_EQ(guessRobots({command, odometry})[0].robot.name, "base_driver") << "nobody tells of nodes";
    command.nodes = odometry.nodes = {"/base_driver"};
    EXPECT_EQ(guessRobots({command, odometry})[0].robot.name, "robot");
    command.nodes = odometry.nodes = {"/base_driver/driver"};
    EXPECT_EQ(guessRobots({command, odometry})[0].robot.name, "base_driver");
}

TEST(RobotGuess, OfOneCamerasPicturesThoseAreTakenThatCostLess) {
    const auto guesses = guessRobots(turtlebot4(""));
    ASSERT_EQ(guesses.size(), 1U);
    const RobotDescription& robot = guesses[0].robot;
    EXPECT_EQ(std::count_if(robot.streams.begin(), robot.streams.end(),
                            [](const auto& one) { return one.role == StreamRole::Picture; }),
              1);
    const StreamDescription* const picture = robot.stream(StreamRole::Picture, "oakd_rgb_preview");
    ASSERT_NE(picture, nullptr);
    EXPECT_EQ(picture->topic, "/oakd/rgb/preview/image_raw/compressed");
    EXPECT_EQ(picture->qos.reliability, Qos::Reliability::BestEffort);
    EXPECT_EQ(topicOf(guesses[0], StreamRole::CameraInfo, "oakd_rgb_preview"),
              "/oakd/rgb/preview/camera_info");
    EXPECT_THAT(verdictOn(guesses[0], "/oakd/rgb/preview/image_raw").remark, HasSubstr("compressed"));
    EXPECT_THAT(verdictOn(guesses[0], "/oakd/stereo/image_raw").remark, HasSubstr("depths"));
}

TEST(RobotGuess, AVideoIsTakenBeforeSinglePictures) {
    const auto guesses = guessRobots(
        {topic("/odom", "nav_msgs/msg/Odometry"), topic("/front/image_raw", "sensor_msgs/msg/Image"),
         topic("/front/image_raw/compressed", "sensor_msgs/msg/CompressedImage"),
         topic("/front/image_raw/ffmpeg", "ffmpeg_image_transport_msgs/msg/FFMPEGPacket"),
         topic("/front/camera_info", "sensor_msgs/msg/CameraInfo"),
         topic("/rear/video", "foxglove_msgs/msg/CompressedVideo")});
    ASSERT_EQ(guesses.size(), 1U);
    EXPECT_EQ(topicOf(guesses[0], StreamRole::Picture, "front"), "/front/image_raw/ffmpeg");
    EXPECT_EQ(topicOf(guesses[0], StreamRole::CameraInfo, "front"), "/front/camera_info");
    EXPECT_EQ(topicOf(guesses[0], StreamRole::Picture, "rear"), "/rear/video");
    for (const char* name : {"/front/image_raw", "/front/image_raw/compressed"}) {
        EXPECT_FALSE(verdictOn(guesses[0], name).role) << name;
        EXPECT_THAT(verdictOn(guesses[0], name).remark, HasSubstr("the same pictures come"));
    }
}

TEST(RobotGuess, DepthPicturesAreTakenWhereNothingElseScans) {
    std::vector<SeenTopic> depths = {
        topic("/odom", "nav_msgs/msg/Odometry"), topic("/cam/depth/image_raw", "sensor_msgs/msg/Image"),
        topic("/cam/depth/image_raw/compressed", "sensor_msgs/msg/CompressedImage"),
        topic("/cam/depth/image_raw/compressedDepth", "sensor_msgs/msg/CompressedImage"),
        topic("/cam/depth/camera_info", "sensor_msgs/msg/CameraInfo")};
    const auto guesses = guessRobots(depths);
    ASSERT_EQ(guesses.size(), 1U);
    const StreamDescription* const points = guesses[0].robot.stream(StreamRole::Points);
    ASSERT_NE(points, nullptr);
    EXPECT_EQ(points->topic, "/cam/depth/image_raw/compressedDepth");
    EXPECT_EQ(points->sensor, "cam_depth");
    EXPECT_EQ(points->qos.reliability, Qos::Reliability::BestEffort);
    EXPECT_EQ(topicOf(guesses[0], StreamRole::CameraInfo, "cam_depth"), "/cam/depth/camera_info");
    EXPECT_EQ(guesses[0].robot.stream(StreamRole::Picture), nullptr);

    depths.push_back(topic("/scan", "sensor_msgs/msg/LaserScan"));
    const auto beside = guessRobots(depths);
    ASSERT_EQ(beside.size(), 1U);
    EXPECT_EQ(beside[0].robot.stream(StreamRole::Points), nullptr) << "they would fill the link";
    EXPECT_THAT(verdictOn(beside[0], "/cam/depth/image_raw/compressedDepth").remark,
                HasSubstr("role points"));
    EXPECT_EQ(beside[0].robot.stream(StreamRole::CameraInfo), nullptr);
}

TEST(RobotGuess, InfraredPicturesKeepTheirTemperatures) {
    const auto guesses = guessRobots(
        {topic("/odom", "nav_msgs/msg/Odometry"), topic("/thermal/image_raw", "sensor_msgs/msg/Image"),
         topic("/thermal/image_raw/compressed", "sensor_msgs/msg/CompressedImage")});
    ASSERT_EQ(guesses.size(), 1U);
    EXPECT_EQ(topicOf(guesses[0], StreamRole::Thermal, "thermal"), "/thermal/image_raw");
}

TEST(RobotGuess, AnOldDriveCommandDoesNotCountForLong) {
    const auto guesses = guessRobots(turtlebot4(""));
    EXPECT_GT(guesses.at(0).robot.stream(StreamRole::DriveCommand)->qos.lifespan, 0.0);
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

SeenTopic modelOf(const std::string& links) {
    SeenTopic seen = topic("/robot_description", "std_msgs/msg/String");
    seen.model =
        std::make_shared<const Result<BodyExtent>>(extentOfModel("<robot name=\"r\">" + links + "</robot>"));
    return seen;
}

const std::string Mesh = "<geometry><mesh filename=\"package://a/b.dae\"/></geometry>";

TEST(RobotGuess, SizesAreTakenFromTheRobotsModel) {
    const auto guesses = guessRobots(
        {topic("/odom", "nav_msgs/msg/Odometry"),
         modelOf("<link name=\"base_link\"><visual>" + Mesh +
                 "</visual><collision><origin xyz=\"0.1 0 0.2\"/><geometry><box size=\"0.8 0.6 0.4\"/>"
                 "</geometry></collision></link>")});
    ASSERT_EQ(guesses.size(), 1U);
    ASSERT_NE(guesses[0].robot.stream(StreamRole::Model), nullptr);
    EXPECT_NEAR(guesses[0].robot.height, 0.4, 1e-6);
    ASSERT_EQ(guesses[0].robot.footprint.size(), 4U);
    // Where the outline begins is nobody's business.
    const auto& outline = guesses[0].robot.footprint;
    const auto [back, front] =
        std::minmax_element(outline.begin(), outline.end(),
                            [](const auto& one, const auto& other) { return one.x() < other.x(); });
    EXPECT_NEAR(back->x(), -0.3, 1e-6);
    EXPECT_NEAR(front->x(), 0.5, 1e-6);
    EXPECT_THAT(verdictOn(guesses[0], "/robot_description").remark, HasSubstr("footprint and height"));
}

TEST(RobotGuess, AModelThatShowsOnlyPartOfTheRobotTellsNoSize) {
    const auto guesses = guessRobots(
        {topic("/odom", "nav_msgs/msg/Odometry"),
         modelOf("<link name=\"base_link\"><visual>" + Mesh +
                 "</visual></link><link name=\"wheel\"><visual><geometry><sphere radius=\"0.1\"/></geometry>"
                 "</visual></link><joint name=\"j\" type=\"fixed\"><parent link=\"base_link\"/>"
                 "<child link=\"wheel\"/></joint>")});
    EXPECT_TRUE(guesses[0].robot.footprint.empty());
    EXPECT_THAT(verdictOn(guesses[0], "/robot_description").remark,
                HasSubstr("are meshes that are not here"));
    const auto broken = guessRobots({topic("/odom", "nav_msgs/msg/Odometry"), modelOf("<link>")});
    EXPECT_TRUE(broken[0].robot.footprint.empty());
    EXPECT_THAT(verdictOn(broken[0], "/robot_description").remark, HasSubstr("cannot be drawn"));
}

TEST(RobotGuess, OtherTextsAreNoModels) {
    const auto guesses =
        guessRobots({topic("/odom", "nav_msgs/msg/Odometry"), topic("/ip", "std_msgs/msg/String")});
    EXPECT_EQ(verdictOn(guesses[0], "/ip").role, std::nullopt);
    EXPECT_EQ(verdictOn(guesses[0], "/ip").remark, "nothing in the station shows it");
}

}  // namespace
}  // namespace leitstand::test
