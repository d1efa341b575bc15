#include "app/services/mapping/robot_sight.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/cloud_sample.h"
#include "core/event/motion_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/stream_role.h"
#include "core/perception/pictures/video/video_packet.h"
#include "core/robot/streams/stream_defaults.h"
#include "core/robot/streams/stream_table.h"
#include "tests/support/samples.h"

namespace leitstand::test {
namespace {

constexpr Time Stamp{std::chrono::seconds(1'000)};
constexpr double BoardAt = 1.5;  ///< ahead [m]
constexpr double Free = std::numeric_limits<double>::infinity();

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

/// What the scanner sees of a floor ahead that ends at @p end.
class Ground {
public:
    explicit Ground(double end) {
        m_cloud.header = {Stamp, "laser"};
        for (double x = 0.5; x < end; x += 0.05) across(x, 0.0);
    }
    /// Points in a row across the way, at @p x ahead and @p z above the ground.
    void across(double x, double z) {
        for (int i = -60; i <= 60; ++i)
            m_cloud.points.push_back(Eigen::Vector3d(x, 0.01 * i, z - 0.5).cast<float>());
    }
    [[nodiscard]] const CloudSample& cloud() const { return m_cloud; }

private:
    CloudSample m_cloud;
};

/// A floor, and a board across the way whose lower edge is @p under above it.
CloudSample boardOver(double under) {
    Ground ground(4.0);
    for (int i = 0; i < 5; ++i) ground.across(BoardAt, under + 0.02 * i);
    return ground.cloud();
}

/// A floor that rises by @p slope from @p begin on, for a metre.
CloudSample rampFrom(double begin, double slope) {
    Ground ground(begin);
    for (double way = 0.0; way < 1.0; way += 0.02) ground.across(begin + way, way * std::tan(slope));
    return ground.cloud();
}

/// Distance of what a robot would run into straight ahead [m]; infinite: nothing.
double aheadOf(const RobotDescription& robot, const CloudSample& cloud) {
    RobotSight sight(robot);
    const SteadyTime now = std::chrono::steady_clock::now();
    OdometrySample odometry;
    odometry.header = {Stamp, "odom"};
    odometry.childFrame = "base_link";
    sight.onEvent(eventOf(StreamRole::Odometry, {}, odometry), now);
    sight.onEvent(eventOf(StreamRole::Points, "scanner", cloud), now);
    const auto view = sight.view(now);
    return view ? view->nearest(degrees(-6), degrees(6)) : -1.0;
}

TEST(RobotSight, ShowsABoardThatATallRobotRunsInto) {
    EXPECT_NEAR(aheadOf(robotOf(1.2), boardOver(0.9)), BoardAt, 0.1);
    EXPECT_EQ(aheadOf(robotOf(0.65), boardOver(0.9)), Free);
    EXPECT_NEAR(aheadOf(robotOf(0.65), boardOver(0.68)), BoardAt, 0.1) << "too little to be sure of";
    EXPECT_EQ(aheadOf(robotOf(0.35), boardOver(0.68)), Free) << "a low one drives under it";
}

/// Whether a robot knows anything around it after one sample of a kind.
bool showsSomething(const SampleCase& one) {
    const RobotDescription robot = robotOf(0.65);  // outlives what looks
    RobotSight sight(robot);
    const SteadyTime now = std::chrono::steady_clock::now();
    OdometrySample odometry;
    odometry.header = {Stamp, "odom"};
    odometry.childFrame = "base_link";
    const Time sampled(std::chrono::seconds(1'700'000'001));  // by sampleCases()
    for (int i = -20; i <= 40; ++i) {
        odometry.header.stamp = sampled + i * std::chrono::milliseconds(50);
        sight.onEvent(eventOf(StreamRole::Odometry, {}, odometry), now);
    }
    Event event = eventOf(*one.role, "scanner", one.sample);
    event.topic = one.stream().topic;
    sight.onEvent(event, now);
    const auto view = sight.view(now);
    return view && std::isfinite(view->youngest());
}

TEST(RobotSight, TakesEveryRoleThatShowsWhatStandsAround) {
    for (const SampleCase& one : sampleCases()) {
        if (!one.role) continue;
        const bool shows = streamFacts(*one.role).sight != Sight::None;
        EXPECT_EQ(showsSomething(one), shows) << nameOf(*one.role) << ", " << one.type;
    }
}

TEST(RobotSight, TakesARampForFloorWhereTheRobotClimbsIt) {
    RobotDescription robot = robotOf(0.65);
    const double beginsAt = 1.5;
    EXPECT_NEAR(aheadOf(robot, rampFrom(beginsAt, degrees(30))), beginsAt + 0.4, 0.35);
    robot.maxClimb = degrees(35);
    EXPECT_EQ(aheadOf(robot, rampFrom(beginsAt, degrees(30))), Free);
}

TEST(RobotSight, ARobotThatStartedAgainBringsNoObstaclesAlong) {
    const auto seconds = [](double time) {
        return std::chrono::nanoseconds(static_cast<std::int64_t>(time * 1e9));
    };
    const auto aheadAfter = [&](double pause, const Pose& from, const Pose& to) {
        const RobotDescription robot = robotOf(1.2);
        RobotSight sight(robot);
        SteadyTime now = std::chrono::steady_clock::now();
        OdometrySample odometry;
        odometry.header = {Stamp, "odom"};
        odometry.childFrame = "base_link";
        odometry.baseInOdom = from;
        sight.onEvent(eventOf(StreamRole::Odometry, {}, odometry), now);
        sight.onEvent(eventOf(StreamRole::Points, "scanner", boardOver(0.3)), now);
        now += seconds(pause);
        odometry.header.stamp += seconds(pause);
        odometry.baseInOdom = to;
        sight.onEvent(eventOf(StreamRole::Odometry, {}, odometry), now);
        return sight.view(now)->nearest(degrees(-6), degrees(6));
    };
    const Pose there = poseFrom({3.0, 1.0, 0}, 0, 0, 0);
    EXPECT_NEAR(aheadAfter(2.0, there, there * poseFrom({0.2, 0, 0}, 0, 0, 0)), BoardAt - 0.2, 0.15)
        << "it was silent and drove on";
    EXPECT_EQ(aheadAfter(2.0, there, Pose::Identity()), Free) << "it started again";
    EXPECT_EQ(aheadAfter(0.1, there, poseFrom({-2.0, 0, 0}, 0, 0, 0)), Free) << "no robot is so fast";
    EXPECT_NEAR(aheadAfter(2.0, Pose::Identity(), Pose::Identity()), BoardAt, 0.15) << "it stood";
}

std::chrono::milliseconds ms(int count) {
    return std::chrono::milliseconds(count);
}

/// A robot, what it says, and when that comes.
struct Pending {
    void odometry(int stamp, const Pose& base, int comes) {
        OdometrySample sample;
        sample.header = {Stamp + ms(stamp), "odom"};
        sample.childFrame = "base_link";
        sample.baseInOdom = base;
        sight.onEvent(eventOf(StreamRole::Odometry, {}, sample), begin + ms(comes));
    }
    void gyro(int stamp, double rate, int comes) {
        ImuSample sample;
        sample.header = {Stamp + ms(stamp), "base_link"};
        sample.angularVelocity = Eigen::Vector3d(0, 0, rate);
        sight.onEvent(eventOf(StreamRole::Imu, "imu", sample), begin + ms(comes));
    }
    /// A board straight ahead of where the robot is when it stands at odom's zero, as seen from @p base.
    void board(int stamp, const Pose& base, int comes) {
        CloudSample cloud = boardOver(0.3);
        cloud.header.stamp = Stamp + ms(stamp);
        const Pose laser = poseFrom({0, 0, 0.5}, 0, 0, 0);
        const Eigen::Isometry3f seen = (laser.inverse() * base.inverse() * laser).cast<float>();
        for (Eigen::Vector3f& point : cloud.points) point = seen * point;
        sight.onEvent(eventOf(StreamRole::Points, "scanner", cloud), begin + ms(comes));
    }
    /// Something else.
    void joints(int comes) {
        sight.onEvent(eventOf(StreamRole::Joints, {}, JointSample{}), begin + ms(comes));
    }
    /// Where the middle of the board is seen, in odom [degrees], while the robot is at @p heading [rad].
    [[nodiscard]] double middleOfBoard(int at, double heading) const {
        const auto view = sight.view(begin + ms(at));
        if (!view) return 1e9;
        double sum = 0.0;
        int count = 0;
        for (const VirtualSector& sector : view->sectors) {
            if (!sector.inner) continue;
            sum += std::remainder(std::atan2(sector.inner->y(), sector.inner->x()) + heading, 2.0 * M_PI);
            ++count;
        }
        return count > 0 ? inDegrees(sum / count) : 1e9;
    }
    const RobotDescription description = robotOf(1.2);
    RobotSight sight{description};
    SteadyTime begin = SteadyTime(std::chrono::seconds(5'000));
};

Pose headed(double heading) {
    return poseFrom({0, 0, 0}, 0, 0, heading);
}

TEST(RobotSight, WhatItSeesWaitsForOdometryThatComesALittleLate) {
    Pending robot;
    const auto headingAt = [](int stamp) { return degrees(0.09) * std::max(0, stamp); };  // it begins to turn
    for (int stamp = -500; stamp <= 0; stamp += 50) robot.odometry(stamp, headed(0), stamp + 100);
    robot.board(100, headed(headingAt(100)), 110);
    EXPECT_EQ(robot.sight.view(robot.begin + ms(110))->nearest(degrees(-40), degrees(40)), Free)
        << "it waits";
    for (int stamp = 50; stamp <= 150; stamp += 50)
        robot.odometry(stamp, headed(headingAt(stamp)), stamp + 100);
    EXPECT_NEAR(robot.middleOfBoard(250, headingAt(150)), 0.0, 1.0);
}

TEST(RobotSight, WhereOdometryComesTooLateTheMotionGoesOn) {
    for (const bool gyros : {false, true}) {
        Pending robot;
        // With gyros it begins to turn as the odometry falls silent.
        const auto headingAt = [&](int stamp) {
            return degrees(0.09) * (gyros ? std::max(0, stamp) : stamp);
        };
        for (int stamp = -500; stamp <= 0; stamp += 50)
            robot.odometry(stamp, headed(headingAt(stamp)), stamp + 10);
        for (int stamp = -500; gyros && stamp <= 400; stamp += 20)
            robot.gyro(stamp, stamp > 0 ? degrees(90) : 0.0, stamp + 10);
        robot.board(400, headed(headingAt(400)), 410);
        robot.joints(600);
        robot.odometry(450, headed(headingAt(450)), 900);
        EXPECT_NEAR(robot.middleOfBoard(900, headingAt(450)), 0.0, 2.0) << gyros;
    }
}

TEST(RobotSight, AClockThatWasSetBackMixesNoEarlierPlacesIn) {
    Pending robot;
    const auto driven = [](int stamp) { return poseFrom({1e-4 * (stamp + 60'000), 0, 0}, 0, 0, 0); };
    for (int stamp = -60'000; stamp <= 0; stamp += 50) robot.odometry(stamp, driven(stamp), stamp);
    robot.board(0, headed(0), 0);
    const auto ahead = [&](int at) {
        return robot.sight.view(robot.begin + ms(at))->nearest(degrees(-6), degrees(6));
    };
    EXPECT_NEAR(ahead(0), BoardAt, 0.1);
    robot.odometry(-40'000, driven(0), 50);
    robot.odometry(100, driven(0), 100);
    EXPECT_NEAR(ahead(100), BoardAt, 0.1) << "one stamp is no clock";
    for (int passed = 25; passed <= 2'000; passed += 50) {
        robot.odometry(-40'000 + passed, driven(0), 100 + passed);
        if (passed % 500 == 25) robot.board(-40'000 + passed, headed(0), 100 + passed);
        if (passed == 75) {
            EXPECT_EQ(ahead(175), Free) << "what was around is of another time";
        }
    }
    EXPECT_NEAR(ahead(2'100), BoardAt, 0.1);
}

TEST(RobotSight, HasWhatALaserMeasuredAsItCameAndNotForLong) {
    const RobotDescription robot = robotOf(1.2);
    RobotSight sight(robot);
    const SteadyTime now = std::chrono::steady_clock::now();
    OdometrySample odometry;
    odometry.header = {Stamp, "odom"};
    odometry.childFrame = "base_link";
    sight.onEvent(eventOf(StreamRole::Odometry, {}, odometry), now);
    RangesSample turn;
    turn.header = {Stamp, "laser"};
    turn.angleStep = degrees(1);
    turn.rangeMax = 8.0;
    turn.ranges = {2.0F};
    sight.onEvent(eventOf(StreamRole::Ranges, "scanner", turn), now);
    odometry.baseInOdom = poseFrom({0.5, 0, 0}, 0, 0, 0);
    odometry.header.stamp += std::chrono::milliseconds(500);
    sight.onEvent(eventOf(StreamRole::Odometry, {}, odometry), now + std::chrono::milliseconds(500));
    const auto view = sight.view(now + std::chrono::milliseconds(500));
    ASSERT_EQ(view->laser.size(), 1u);
    EXPECT_NEAR(view->laser.front().x(), 1.5F, 1e-4F) << "it drove on since";
    EXPECT_NEAR(view->laserAge, 0.5, 1e-6);
    EXPECT_TRUE(sight.view(now + std::chrono::seconds(3))->laser.empty());
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
        sight().onEvent(eventOf(role, sensor, sample), now);
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
    sight().selectCamera("ir");
    EXPECT_EQ(capAfter(0.1).reason, SightReason::Fresh);
    EXPECT_EQ(capAfter(0.1).factor, 1.0);
    EXPECT_EQ(capAfter(0.5).factor, SightRules{}.creepShare);
    EXPECT_EQ(capAfter(1.5).reason, SightReason::OldPicture);
    EXPECT_EQ(capAfter(1.5).factor, 0.0);
}

TEST_F(TwoCameras, AFreshPictureThatIsNotLargeIsNoEyes) {
    sight().selectCamera("ir");
    picture(StreamRole::Picture, "left", 1);
    EXPECT_EQ(capAfter(0.1).reason, SightReason::NoPicture);
    picture(StreamRole::Thermal, "ir", 1);
    now += std::chrono::seconds(2);
    picture(StreamRole::Thermal, "ir", 1);
    EXPECT_EQ(capAfter(0.1).reason, SightReason::FrozenPicture) << "an infrared camera can hang, too";
    EXPECT_EQ(capAfter(0.1).factor, 0.0);
}

TEST_F(TwoCameras, PicturesOfAVideoThatCannotBeDecodedAreNotSeen) {
    const auto film = [&](bool decodable, int content) {
        PictureSample sample;
        const auto bytes = std::make_shared<std::vector<std::byte>>(100, static_cast<std::byte>(content));
        sample.content = {bytes, *bytes};
        sample.video =
            std::make_shared<const VideoPacket>(VideoPacket{.key = decodable, .bytes = sample.content});
        sight().onEvent(eventOf(StreamRole::Picture, "left", sample), now);
    };
    film(true, 1);
    EXPECT_EQ(capAfter(0.1).reason, SightReason::Fresh);
    now += std::chrono::seconds(2);
    film(false, 2);
    EXPECT_EQ(capAfter(0.1).reason, SightReason::OldPicture) << "the driver looks at the one before";
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
    sight().fillView(view, now);
    ASSERT_EQ(view.cameras.size(), 1u);
    EXPECT_EQ(view.cameras[0].sensor, "left");
}

}  // namespace
}  // namespace leitstand::test
