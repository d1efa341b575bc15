#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/sample.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/robot/frame_names.h"
#include "messages/diagnostic_msgs.h"
#include "messages/map_msgs.h"
#include "messages/nav_msgs.h"
#include "messages/sensor_msgs.h"
#include "messages/tf2_msgs.h"
#include "tests/transport/convert/conversion.h"

namespace leitstand::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr float NaN = std::numeric_limits<float>::quiet_NaN();

/// A message as it reaches the station on @p stream.
template <class Message>
RawEvent eventOf(const Message& message, const StreamDescription& stream) {
    CdrWriter out;
    encode(out, message);
    return {1,
            {},
            stream.topic,
            stream.type,
            std::make_shared<const std::vector<std::byte>>(std::move(out).finish())};
}

template <class Message>
StreamDescription streamOf(StreamRole role) {
    StreamDescription stream;
    stream.role = role;
    stream.topic = "/robot/topic";
    stream.type = Message::RosName;
    return stream;
}

template <class Message>
Result<Sample> decoded(const Message& message, StreamRole role) {
    const StreamDescription stream = streamOf<Message>(role);
    return decode(eventOf(message, stream), stream);
}

template <class Message>
std::string errorOf(const Message& message, StreamRole role) {
    const auto sample = decoded(message, role);
    return sample ? "none" : sample.error().text;
}

RobotDescription robot(TfPrefix prefix) {
    RobotDescription robot;
    robot.name = "kurt3d";
    robot.tfPrefix = prefix;
    return robot;
}

wire::tf2_msgs::TFMessage transforms(const std::vector<std::pair<std::string, std::string>>& frames) {
    wire::tf2_msgs::TFMessage message;
    for (const auto& [parent, child] : frames) {
        auto& one = message.transforms.emplace_back();
        one.header.frame_id = parent;
        one.child_frame_id = child;
        one.transform.rotation.w = 1.0;
    }
    return message;
}

/// "parent > child" of what the station makes of @p message.
std::vector<std::string> frames(const wire::tf2_msgs::TFMessage& message, TfPrefix prefix) {
    const auto stream = streamOf<wire::tf2_msgs::TFMessage>(StreamRole::Transforms);
    const auto event = decodeEvent(eventOf(message, stream), robot(prefix), stream);
    if (!event) return {event.error().text};
    std::vector<std::string> found;
    for (const FrameTransform& one : event->sample.get<TransformsSample>().transforms) {
        found.push_back(one.header.frame + " > " + one.childFrame);
    }
    return found;
}

TEST(Frames, AreNamedAfterTheRobotWhereItsTopicSaysWhoItIs) {
    const auto message = transforms({{"odom", "base_link"}, {"/base_link", "kurt3d/lidar"}});
    EXPECT_THAT(frames(message, TfPrefix::Topic),
                ElementsAre("kurt3d/odom > kurt3d/base_link", "kurt3d/base_link > kurt3d/lidar"));
    EXPECT_THAT(frames(message, TfPrefix::None), ElementsAre("odom > base_link", "base_link > kurt3d/lidar"));
}

TEST(Frames, OfOtherRobotsOnASharedTopicAreLeftOut) {
    const auto message = transforms({{"kurt3d/odom", "kurt3d/base_link"},
                                     {"crawler/odom", "crawler/base_link"},
                                     {"map", "kurt3d/odom"},
                                     {"kurt3d2/odom", "kurt3d2/base_link"}});
    EXPECT_THAT(frames(message, TfPrefix::Frame),
                ElementsAre("kurt3d/odom > kurt3d/base_link", "map > kurt3d/odom"));
}

TEST(Frames, OfEverySampleAreNamedAlike) {
    wire::nav_msgs::Odometry odometry;
    odometry.header.frame_id = "odom";
    odometry.child_frame_id = "base_link";
    odometry.pose.pose.orientation.w = 1.0;
    auto stream = streamOf<wire::nav_msgs::Odometry>(StreamRole::Odometry);
    stream.sensor = "wheels";
    const auto event = decodeEvent(eventOf(odometry, stream), robot(TfPrefix::Topic), stream);
    ASSERT_TRUE(event) << event.error().text;
    EXPECT_EQ(event->robot, "kurt3d");
    EXPECT_EQ(event->role, StreamRole::Odometry);
    EXPECT_EQ(event->sensor, "wheels");
    EXPECT_EQ(event->sample.get<OdometrySample>().header.frame, "kurt3d/odom");
    EXPECT_EQ(event->sample.get<OdometrySample>().childFrame, "kurt3d/base_link");
    EXPECT_EQ(frameName(robot(TfPrefix::Topic), ""), "");
}

TEST(Transforms, NeedTwoFramesAndARotation) {
    using wire::tf2_msgs::TFMessage;
    const auto role = StreamRole::StaticTransforms;
    EXPECT_EQ(errorOf(transforms({{"a", "b"}}), role), "none");
    EXPECT_THAT(errorOf(transforms({{"a", "a"}}), role), HasSubstr("two different frames"));
    EXPECT_THAT(errorOf(transforms({{"", "a"}}), role), HasSubstr("two different frames"));
    TFMessage message = transforms({{"a", "b"}});
    message.transforms[0].transform.rotation.w = 0.0;
    EXPECT_THAT(errorOf(message, role), HasSubstr("quaternion"));
    message = transforms({{"a", "b"}});
    message.transforms[0].transform.translation.x = Infinity;
    EXPECT_THAT(errorOf(message, role), HasSubstr("translation"));
}

TEST(Diagnostics, OnlyThoseOfTheRobotsHardwareCount) {
    using wire::diagnostic_msgs::DiagnosticArray;
    DiagnosticArray message;
    message.status = {
        {0, "a", "", "kurt3d/motor", {}}, {2, "b", "", "crawler/motor", {}}, {1, "c", "", "kurt3d", {}}};
    auto stream = streamOf<DiagnosticArray>(StreamRole::Diagnostics);
    const auto names = [&] {
        std::string text;
        const auto sample = decode(eventOf(message, stream), stream);
        for (const auto& status : sample->get<DiagnosticsSample>().statuses) text += status.name;
        return text;
    };
    EXPECT_EQ(names(), "abc");
    stream.hardwareId = "kurt3d";
    EXPECT_EQ(names(), "ac");
    message.status[0].level = 4;
    EXPECT_THAT(errorOf(message, StreamRole::Diagnostics), HasSubstr("status.level"));
}

TEST(Gas, MayBeABareNumber) {
    wire::std_msgs::Float32 message{415.5F};
    auto stream = streamOf<wire::std_msgs::Float32>(StreamRole::Gas);
    stream.sensor = "methane";
    const auto sample = decode(eventOf(message, stream), stream);
    ASSERT_TRUE(sample);
    EXPECT_EQ(sample->get<GasSample>().ppm, 415.5);
    EXPECT_EQ(sample->get<GasSample>().gas, "methane");
    for (const float wrong : {NaN, -1.0F, 2e6F}) {
        message.data = wrong;
        EXPECT_THAT(errorOf(message, StreamRole::Gas), HasSubstr("ppm"));
    }
}

TEST(Imu, TellsWhatItDoesNotMeasure) {
    wire::sensor_msgs::Imu message;
    message.orientation_covariance[0] = -1.0;
    message.linear_acceleration_covariance[0] = -1.0;
    message.angular_velocity.z = 0.5;
    message.angular_velocity_covariance[0] = Infinity;
    const auto sample = decoded(message, StreamRole::Imu);
    ASSERT_TRUE(sample) << sample.error().text;
    const auto& imu = sample->get<ImuSample>();
    EXPECT_FALSE(imu.orientation);
    EXPECT_FALSE(imu.linearAcceleration);
    EXPECT_EQ(imu.angularVelocity, Eigen::Vector3d(0, 0, 0.5));
    EXPECT_EQ(imu.angularVelocityCovariance[0], 0.0);
}

TEST(Battery, UnderstandsPercentAndUnmeasuredNumbers) {
    wire::sensor_msgs::BatteryState message;
    message.percentage = 87.0F;
    message.voltage = NaN;
    message.power_supply_status = 77;
    const auto sample = decoded(message, StreamRole::Battery);
    ASSERT_TRUE(sample);
    const auto& battery = sample->get<BatterySample>();
    EXPECT_DOUBLE_EQ(battery.fraction, 0.87);
    EXPECT_TRUE(std::isnan(battery.voltage));
    EXPECT_EQ(battery.status, BatterySample::Status::Unknown);
    message.percentage = -1.0F;
    EXPECT_TRUE(std::isnan(decoded(message, StreamRole::Battery)->get<BatterySample>().fraction));
}

TEST(Ranges, NeedAnglesAndMatchingLists) {
    wire::sensor_msgs::LaserScan message;
    message.ranges = {1.0F, NaN, std::numeric_limits<float>::infinity()};
    message.angle_increment = 0.1F;
    message.range_max = 10.0F;
    EXPECT_EQ(errorOf(message, StreamRole::Ranges), "none");
    auto wrong = message;
    wrong.intensities = {1.0F};
    EXPECT_THAT(errorOf(wrong, StreamRole::Ranges), HasSubstr("intensities"));
    wrong = message;
    wrong.angle_increment = 0.0F;
    EXPECT_THAT(errorOf(wrong, StreamRole::Ranges), HasSubstr("angle_increment"));
    wrong = message;
    wrong.angle_min = NaN;
    EXPECT_THAT(errorOf(wrong, StreamRole::Ranges), HasSubstr("angle_min"));
    wrong = message;
    wrong.range_min = 11.0F;
    EXPECT_THAT(errorOf(wrong, StreamRole::Ranges), HasSubstr("range_max"));
}

TEST(Ranges, OfATurnThatTakesForEverAreRefused) {
    wire::sensor_msgs::LaserScan message;
    message.ranges.assign(1000, 1.0F);
    message.angle_increment = 0.001F;
    message.range_max = 10.0F;
    for (const float good : {0.0F, 1e-4F, -1e-4F, 0.05F}) {
        message.time_increment = good;
        EXPECT_EQ(errorOf(message, StreamRole::Ranges), "none") << good;
    }
    for (const float bad : {0.07F, -0.07F, 1e30F, -1e30F, std::numeric_limits<float>::infinity(), NaN}) {
        message.time_increment = bad;
        EXPECT_THAT(errorOf(message, StreamRole::Ranges), HasSubstr("time_increment")) << bad;
    }
}

TEST(Odometry, MustBeNumbers) {
    wire::nav_msgs::Odometry message;
    message.pose.pose.orientation.w = 1.0;
    message.pose.covariance[7] = Infinity;
    EXPECT_EQ(errorOf(message, StreamRole::Odometry), "none");
    auto wrong = message;
    wrong.twist.twist.angular.z = Infinity;
    EXPECT_THAT(errorOf(wrong, StreamRole::Odometry), HasSubstr("angular"));
    wrong = message;
    wrong.pose.pose.orientation.w = 2.0;
    EXPECT_THAT(errorOf(wrong, StreamRole::Odometry), HasSubstr("quaternion of length 1"));
    wrong = message;
    wrong.header.stamp.sec = -5;
    EXPECT_THAT(errorOf(wrong, StreamRole::Odometry), HasSubstr("header.stamp"));
}

TEST(Grids, MustFitTheirSizes) {
    wire::nav_msgs::OccupancyGrid message;
    EXPECT_EQ(errorOf(message, StreamRole::Grid), "none") << "before the first map";
    message.info.width = 3;
    message.info.height = 2;
    message.info.resolution = 0.05F;
    message.data.assign(6, 0);
    const auto grid = decoded(message, StreamRole::Grid);
    ASSERT_TRUE(grid) << grid.error().text;
    EXPECT_TRUE(grid->get<OccupancyGridSample>().gridInFrame.isApprox(Pose::Identity()))
        << "whoever sets no rotation means none";
    const auto changed = [&](auto change) {
        auto wrong = message;
        change(wrong);
        return errorOf(wrong, StreamRole::Grid);
    };
    EXPECT_THAT(changed([](auto& one) { one.data.pop_back(); }), HasSubstr("3 x 2 cells, found 5"));
    EXPECT_THAT(changed([](auto& one) { one.info.width = 0xffff'ffff; }), HasSubstr("width"));
    EXPECT_THAT(changed([](auto& one) { one.info.width = one.info.height = 65'536; }),
                HasSubstr("at most 16000000 cells"));
    EXPECT_THAT(changed([](auto& one) { one.info.width = 0x8000'0000, one.info.height = 2; }),
                HasSubstr("width"));
    for (const float bad : {0.0F, -1.0F, 1e9F, NaN, std::numeric_limits<float>::infinity()})
        EXPECT_THAT(changed([bad](auto& one) { one.info.resolution = bad; }), HasSubstr("resolution")) << bad;
    EXPECT_THAT(changed([](auto& one) { one.info.origin.position.x = Infinity; }), HasSubstr("origin"));
}

TEST(Grids, UpdatesLieWithinThem) {
    wire::map_msgs::OccupancyGridUpdate message;
    message.width = message.height = 2;
    message.data.assign(4, 100);
    EXPECT_EQ(errorOf(message, StreamRole::GridUpdate), "none");
    message.x = -1;
    EXPECT_THAT(errorOf(message, StreamRole::GridUpdate), HasSubstr("x, y"));
    message.x = std::numeric_limits<std::int32_t>::max();
    EXPECT_THAT(errorOf(message, StreamRole::GridUpdate), HasSubstr("x, y"));
    message.x = 0;
    message.data.push_back(0);
    EXPECT_THAT(errorOf(message, StreamRole::GridUpdate), HasSubstr("2 x 2 cells, found 5"));
}

TEST(Paths, HavePosesThatAreNumbers) {
    wire::nav_msgs::Path message;
    EXPECT_EQ(errorOf(message, StreamRole::Path), "none") << "no way was found";
    message.poses.resize(2);
    EXPECT_EQ(errorOf(message, StreamRole::Path), "none") << "places without rotations";
    message.poses[1].pose.position.y = Infinity;
    EXPECT_THAT(errorOf(message, StreamRole::Path), HasSubstr("poses"));
    message.poses.assign(PathSample::MostPoses + 1, {});
    EXPECT_THAT(errorOf(message, StreamRole::Path), HasSubstr("at most 100000"));
}

TEST(Images, MustFitTheirSizes) {
    const std::vector<std::byte> data(48);
    wire::sensor_msgs::Image message;
    message.width = 4;
    message.height = 4;
    message.encoding = "bgr8";
    message.step = 12;
    message.data = data;
    EXPECT_EQ(errorOf(message, StreamRole::Picture), "none");
    const auto changed = [&](auto change) {
        auto wrong = message;
        change(wrong);
        return errorOf(wrong, StreamRole::Thermal);
    };
    EXPECT_THAT(changed([](auto& m) { m.encoding = "bgr16"; }), HasSubstr("\"bgr16\" cannot be shown"));
    EXPECT_THAT(changed([](auto& m) { m.encoding = "rgba8"; }), HasSubstr("step"));
    EXPECT_THAT(changed([](auto& m) { m.height = 5; }), HasSubstr("data"));
    EXPECT_THAT(changed([](auto& m) { m.width = m.height = m.step = 4'294'967'295; }), HasSubstr("width"));
    EXPECT_THAT(changed([](auto& m) { m.step = 4'294'967'295; }), HasSubstr("data"));
    EXPECT_THAT(changed([](auto& m) { m.width = 0; }), HasSubstr("width"));
    EXPECT_THAT(changed([](auto& m) { m.encoding = "yuyv", m.width = 3; }), HasSubstr("pairs"));
    wire::sensor_msgs::CompressedImage text;
    text.format = "jpeg";
    text.data = data;
    EXPECT_THAT(errorOf(text, StreamRole::Picture), HasSubstr("JPEG or PNG"));
}

}  // namespace
}  // namespace leitstand::test
