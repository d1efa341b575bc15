#include "core/robot/streams/thin_link.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/stream_role.h"

namespace leitstand::test {
namespace {

using testing::IsEmpty;

/// A robot as Kurt3D: 1.5 scans, three cameras, telemetry [Mbit/s].
ThinRobot kurt(const std::string& name, bool selected) {
    ThinRobot robot;
    robot.name = name;
    robot.selected = selected;
    const auto add = [&](StreamRole role, const std::string& leaf, double rate, double megabits) {
        robot.streams.push_back({role, "/" + name + "/" + leaf, rate, megabits});
    };
    add(StreamRole::Points, "points", 10.0, 1.2);
    add(StreamRole::Odometry, "odom", 50.0, 0.15);
    add(StreamRole::Imu, "imu", 50.0, 0.1);
    add(StreamRole::Picture, "left", 15.0, 1.2);
    add(StreamRole::Picture, "right", 15.0, 1.2);
    add(StreamRole::Thermal, "ir", 9.0, 0.9);
    add(StreamRole::StopState, "stop_state", 1.0, 0.001);
    return robot;
}

double costOf(const std::vector<ThinRobot>& robots, const std::map<std::string, StreamRequest>& requests) {
    double sum = 0.0;
    for (const ThinRobot& robot : robots) {
        for (const StreamCost& stream : robot.streams) {
            const auto request = requests.find(stream.topic);
            sum += costUnder(stream, request == requests.end() ? StreamRequest{} : request->second);
        }
    }
    return sum;
}

TEST(ThinLink, WhatFitsIsLeftAsItIs) {
    EXPECT_THAT(thinRequests({kurt("k", true)}, {.budget = 10.0}), IsEmpty());
    EXPECT_THAT(thinRequests({}, {.budget = 0.0}), IsEmpty());
}

TEST(ThinLink, HeadersAreCountedWithWhatTheyCarry) {
    EXPECT_EQ(onTheWire(0.0, 10.0), 0.0);
    EXPECT_EQ(onTheWire(0.1, 0.0), 0.0);
    // 40 transforms of 120 B a second take more than twice of that, 10 slices of 28 kB an eighth more.
    EXPECT_NEAR(onTheWire(40 * 120 * 8e-6, 40.0), 40 * 280 * 8e-6, 1e-9);
    EXPECT_NEAR(onTheWire(10 * 28'060 * 8e-6, 10.0), 10 * (28'060 + 23 * 160) * 8e-6, 1e-9);
}

TEST(ThinLink, TheRestGoesFirstAndComesBackAsAGlimpse) {
    const std::vector<ThinRobot> robots = {kurt("k", true)};
    const auto requests = thinRequests(robots, {.budget = 3.2});
    EXPECT_LE(costOf(robots, requests), 3.0);
    EXPECT_FALSE(requests.contains("/k/points"));
    EXPECT_FALSE(requests.contains("/k/imu"));
    EXPECT_EQ(requests.at("/k/left").rate, 10.0) << "the main camera, hardly reduced";
    EXPECT_EQ(requests.at("/k/right").rate, 1.0);
    EXPECT_EQ(requests.at("/k/ir").rate, 1.0);
    EXPECT_EQ(requests.at("/k/ir").quality, 0) << "temperatures are never made coarse";
}

TEST(ThinLink, TheCameraThatTheDriverLooksThroughIsTheOneThatStays) {
    ThinRobot robot = kurt("k", true);
    robot.camera = "/k/right";
    auto requests = thinRequests({robot}, {.budget = 3.2});
    EXPECT_EQ(requests.at("/k/right").rate, 10.0);
    EXPECT_EQ(requests.at("/k/left").rate, 1.0);
    robot.camera = "/k/ir";
    for (const double budget : {3.0, 2.0, 0.1}) {
        requests = thinRequests({robot}, {.budget = budget});
        EXPECT_TRUE(requests.at("/k/ir").enabled) << budget;
        EXPECT_EQ(requests.at("/k/ir").quality, 0) << "temperatures are never made coarse";
    }
    robot.camera = "/k/odom";
    EXPECT_EQ(thinRequests({robot}, {.budget = 3.2}).at("/k/left").rate, 10.0) << "no camera: its first";
}

TEST(ThinLink, OneCameraIsReducedButNeverOff) {
    double before = 100.0;
    for (const double budget : {3.0, 2.4, 2.0, 1.8, 1.7, 0.1}) {
        const auto requests = thinRequests({kurt("k", true)}, {.budget = budget});
        const StreamRequest& camera = requests.at("/k/left");
        EXPECT_TRUE(camera.enabled);
        EXPECT_LE(camera.rate, before);
        before = camera.rate;
    }
    EXPECT_EQ(before, 1.0);
}

TEST(ThinLink, ScansOfTheSelectedRobotOutliveItsCameraAndThoseOfOthers) {
    const std::vector<ThinRobot> robots = {kurt("k", true), kurt("c", false)};
    const auto requests = thinRequests(robots, {.budget = 2.2});
    EXPECT_LE(costOf(robots, requests), 2.0);
    EXPECT_FALSE(requests.contains("/k/points"));
    EXPECT_FALSE(requests.at("/c/points").enabled);
    EXPECT_LE(requests.at("/c/left").rate, 1.0) << "at most a glimpse";
    EXPECT_FALSE(requests.at("/c/ir").isPlain());
    EXPECT_TRUE(requests.at("/k/left").enabled);
    EXPECT_FALSE(thinRequests(robots, {.budget = 4.0}).contains("/c/points")) << "there is room for it";
}

TEST(ThinLink, TelemetryOutlivesScansAndIsSlowedLast) {
    auto requests = thinRequests({kurt("k", true)}, {.budget = 1.2});
    EXPECT_EQ(requests.at("/k/points").rate, 5.0);
    EXPECT_FALSE(requests.contains("/k/imu"));
    requests = thinRequests({kurt("k", true)}, {.budget = 0.6});
    EXPECT_EQ(requests.at("/k/points").rate, 1.0);
    EXPECT_FALSE(requests.contains("/k/imu"));
    requests = thinRequests({kurt("k", true)}, {.budget = 0.3});
    EXPECT_EQ(requests.at("/k/points").rate, 1.0) << "never off";
    EXPECT_EQ(requests.at("/k/imu").rate, 5.0);
}

TEST(ThinLink, WhatStopsAndWhereRobotsAreIsNeverTouched) {
    const auto requests = thinRequests({kurt("k", true), kurt("c", false)}, {.budget = 0.0});
    for (const char* robot : {"/k", "/c"}) {
        EXPECT_FALSE(requests.contains(std::string(robot) + "/stop_state"));
        EXPECT_FALSE(requests.contains(std::string(robot) + "/odom"));
        EXPECT_EQ(requests.at(std::string(robot) + "/imu").rate, 5.0);
    }
}

TEST(ThinLink, RobotsThatAreNotThinOnlyTakeTheirRoom) {
    ThinRobot other = kurt("c", false);
    other.thin = false;
    const auto requests = thinRequests({kurt("k", true), other}, {.budget = 3.0});
    EXPECT_TRUE(requests.contains("/k/left"));
    for (const auto& [topic, request] : requests) EXPECT_EQ(topic.substr(0, 3), "/k/") << topic;
}

TEST(ThinLink, WhatWasNeverMeasuredCountsAsUsual) {
    ThinRobot robot = kurt("k", true);
    for (StreamCost& stream : robot.streams) stream.rate = 0.0, stream.megabits = -1.0;
    EXPECT_TRUE(thinRequests({robot}, {.budget = 2.0}).contains("/k/right"));
}

TEST(StreamRequest, TheStricterOfTwoSatisfiesBoth) {
    const StreamRequest request = stricter({true, 5.0, 0, 640}, {true, 10.0, 40, 320});
    EXPECT_EQ(request, (StreamRequest{true, 5.0, 40, 320}));
    EXPECT_FALSE(stricter({.enabled = false}, {}).enabled);
    EXPECT_TRUE(stricter({}, {}).isPlain());
}

TEST(StreamRequest, IsFollowedWhenTheRateIsNotAboveIt) {
    StreamStatus stream;
    stream.rate = 15.0;
    stream.age = 0.05;
    EXPECT_TRUE(isFollowed({}, stream));
    EXPECT_FALSE(isFollowed({.rate = 5.0}, stream));
    EXPECT_FALSE(isFollowed({.enabled = false}, stream));
    stream.age = 1.5;
    EXPECT_TRUE(isFollowed({.enabled = false}, stream));
    stream.rate = 5.2;
    EXPECT_TRUE(isFollowed({.rate = 5.0}, stream));
}

}  // namespace
}  // namespace leitstand::test
