#include "app/session/station/robot_sight.h"

#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/robot/stream_defaults.h"

namespace leitstand::test {
namespace {

constexpr Time Stamp{std::chrono::seconds(1'000)};
constexpr double BoardAt = 1.5;  ///< ahead [m]

RobotDescription robotOf(double height) {
    RobotDescription robot;
    robot.name = "tall";
    robot.baseFrame = "base_link";
    robot.odomFrame = "odom";
    robot.footprint = {{0.2, 0.15}, {-0.2, 0.15}, {-0.2, -0.15}, {0.2, -0.15}};
    robot.height = height;
    robot.sensors["scanner"] = {.frame = "laser", .sensorInBase = poseFrom({0.0, 0.0, 0.5}, 0, 0, 0)};
    robot.streams.push_back(defaultStream(StreamRole::Points, robot.name, "scanner"));
    return robot;
}

Event eventOf(StreamRole role, const std::string& sensor, Sample sample) {
    Event event;
    event.received = Stamp;
    event.robot = "tall";
    event.role = role;
    event.sensor = sensor;
    event.sample = std::move(sample);
    return event;
}

/// A floor ahead, and a board across it whose lower edge is @p under above it.
CloudSample boardOver(double under) {
    CloudSample cloud;
    cloud.header = {Stamp, "laser"};
    const auto add = [&cloud](double x, double y, double z) {
        cloud.points.push_back(Eigen::Vector3d(x, y, z - 0.5).cast<float>());
    };
    for (double y = -0.6; y < 0.6; y += 0.01) {
        for (double x = 0.5; x < 4.0; x += 0.05) add(x, y, 0.0);
        for (double z = under; z < under + 0.1; z += 0.02) add(BoardAt, y, z);
    }
    return cloud;
}

/// Distance of what a robot would run into straight ahead [m]; infinite: nothing.
double aheadOf(const RobotDescription& robot, double under) {
    RobotSight sight(robot);
    const SteadyTime now = std::chrono::steady_clock::now();
    OdometrySample odometry;
    odometry.header = {Stamp, "odom"};
    odometry.childFrame = "base_link";
    sight.take(eventOf(StreamRole::Odometry, {}, odometry), now);
    sight.take(eventOf(StreamRole::Points, "scanner", boardOver(under)), now);
    const auto view = sight.view(now);
    return view ? view->nearest(degrees(-6), degrees(6)) : -1.0;
}

TEST(RobotSight, ShowsABoardThatATallRobotRunsInto) {
    constexpr double Free = std::numeric_limits<double>::infinity();
    EXPECT_NEAR(aheadOf(robotOf(1.2), 0.9), BoardAt, 0.1);
    EXPECT_EQ(aheadOf(robotOf(0.65), 0.9), Free);
    EXPECT_NEAR(aheadOf(robotOf(0.65), 0.68), BoardAt, 0.1) << "too little to be sure of";
    EXPECT_EQ(aheadOf(robotOf(0.35), 0.68), Free) << "a low one drives under it";
}

TEST(RobotSight, TakesARampForFloorWhereTheRobotClimbsIt) {
    RobotDescription robot = robotOf(1.2);
    EXPECT_NEAR(aheadOf(robot, 0.9), BoardAt, 0.1);
    robot.maxClimb = degrees(40);  // so steep a ramp would lead onto the board
    EXPECT_EQ(aheadOf(robot, 0.9), std::numeric_limits<double>::infinity());
}

/// A robot with a colour camera and an infrared one, and no scanner.
struct TwoCameras : testing::Test {
    TwoCameras() {
        robot.name = "tall";
        robot.streams = {defaultStream(StreamRole::Picture, robot.name, "left"),
                         defaultStream(StreamRole::Thermal, robot.name, "ir")};
    }
    void picture(StreamRole role, const std::string& sensor, int content) {
        const auto bytes = std::make_shared<std::vector<std::byte>>(100, static_cast<std::byte>(content));
        PictureSample sample;
        sample.content = {bytes, *bytes};
        sight().take(eventOf(role, sensor, sample), now);
    }
    [[nodiscard]] SightCap capAfter(double seconds) {
        return sight().cap({0.2, 0, 0}, false, now + toNanoseconds(seconds));
    }
    RobotSight& sight() {
        if (!made) made.emplace(robot);
        return *made;
    }
    static std::chrono::nanoseconds toNanoseconds(double seconds) {
        return std::chrono::nanoseconds(static_cast<std::int64_t>(seconds * 1e9));
    }

    RobotDescription robot;
    std::optional<RobotSight> made;
    SteadyTime now = SteadyTime(std::chrono::seconds(5'000));
};

TEST_F(TwoCameras, TheLargePictureCapsTheSpeedAlsoWhereItIsInfrared) {
    picture(StreamRole::Thermal, "ir", 1);
    EXPECT_EQ(capAfter(0.1).reason, SightReason::NoPicture) << "the colour camera is large, and says nothing";
    EXPECT_EQ(capAfter(0.1).factor, 0.0);
    sight().lookThrough("ir");
    EXPECT_EQ(capAfter(0.1).reason, SightReason::Fresh);
    EXPECT_EQ(capAfter(0.1).factor, 1.0);
    EXPECT_EQ(capAfter(0.5).factor, SightRules{}.creepShare);
    EXPECT_EQ(capAfter(1.5).reason, SightReason::OldPicture);
    EXPECT_EQ(capAfter(1.5).factor, 0.0);
}

TEST_F(TwoCameras, AFreshPictureThatIsNotLargeIsNoEyes) {
    sight().lookThrough("ir");
    picture(StreamRole::Picture, "left", 1);
    EXPECT_EQ(capAfter(0.1).reason, SightReason::NoPicture);
    picture(StreamRole::Thermal, "ir", 1);
    now += std::chrono::seconds(2);
    picture(StreamRole::Thermal, "ir", 1);
    EXPECT_EQ(capAfter(0.1).reason, SightReason::FrozenPicture) << "an infrared camera can hang, too";
    EXPECT_EQ(capAfter(0.1).factor, 0.0);
}

TEST_F(TwoCameras, InfraredAloneIsACamera) {
    robot.streams.erase(robot.streams.begin());
    EXPECT_EQ(capAfter(0.1).reason, SightReason::NoPicture);
    picture(StreamRole::Thermal, "ir", 1);
    EXPECT_EQ(capAfter(0.1).reason, SightReason::Fresh);
}

TEST_F(TwoCameras, InfraredIsNotAmongTheCamerasThatAreWatchedForRepeatedPictures) {
    picture(StreamRole::Picture, "left", 1);
    picture(StreamRole::Thermal, "ir", 1);
    RobotView view;
    sight().tell(view, now);
    ASSERT_EQ(view.cameras.size(), 1u);
    EXPECT_EQ(view.cameras[0].sensor, "left");
}

}  // namespace
}  // namespace leitstand::test
