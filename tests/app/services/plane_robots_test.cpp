// Robots that see in a plane only, and what makes the map.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/mapping/live_mapping.h"
#include "core/cloud/labels.h"
#include "core/event/cloud_sample.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

const Pose Laser = poseFrom({0.1, 0.0, 0.3}, 0.0, 0.0, degrees(90));

StreamDescription stream(const std::string& robot, StreamRole role, const std::string& name) {
    StreamDescription one;
    one.role = role;
    one.topic = "/" + robot + "/" + name;
    return one;
}

RobotDescription withLaser(const std::string& name) {
    RobotDescription robot;
    robot.name = robot.title = name;
    robot.baseFrame = "base_link";
    robot.odomFrame = "odom";
    robot.footprint = {{0.15, 0.15}, {-0.15, 0.15}, {-0.15, -0.15}, {0.15, -0.15}};
    robot.height = 0.25;
    robot.sensors["laser"].sensorInBase = Laser;
    robot.streams = {stream(name, StreamRole::Ranges, "scan"), stream(name, StreamRole::Odometry, "odom")};
    robot.streams.front().sensor = "laser";
    return robot;
}

RobotDescription withScanner(const std::string& name) {
    RobotDescription robot = withLaser(name);
    robot.streams.front() = stream(name, StreamRole::Points, "points");
    return robot;
}

/// A room of 7 x 5 m with a pillar and a niche, as a ray sees it.
double rangeIn(const Eigen::Vector2d& from, double heading) {
    const Eigen::Vector2d ray(std::cos(heading), std::sin(heading));
    double range = std::numeric_limits<double>::infinity();
    const auto wall = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        Eigen::Matrix2d sides;
        sides << ray, a - b;
        if (std::abs(sides.determinant()) < 1e-9) return;
        const Eigen::Vector2d at = sides.inverse() * (a - from);
        if (at.x() > 0.0 && at.y() >= 0.0 && at.y() <= 1.0) range = std::min(range, at.x());
    };
    const std::vector<Eigen::Vector2d> room = {{-2, -2}, {5, -2}, {5, 0.5}, {4.2, 0.5}, {4.2, 3}, {-2, 3}};
    const std::vector<Eigen::Vector2d> pillar = {{0.5, 1.5}, {0.9, 1.5}, {0.9, 1.9}, {0.5, 1.9}};
    for (const auto* const outline : {&room, &pillar}) {
        for (std::size_t i = 0; i < outline->size(); ++i)
            wall((*outline)[i], (*outline)[(i + 1) % outline->size()]);
    }
    return range;
}

class PlaneRobots : public testing::Test {
protected:
    void begin(const std::vector<RobotDescription>& robots, const EarlierMap& earlier = {}) {
        LiveMappingListener listener;
        listener.onUpdate = [this](const MapUpdate& update) {
            const std::scoped_lock lock(m_mutex);
            if (update.keyScan) m_scans.push_back(*update.keyScan);
            if (update.poses) m_poses = update.poses->poses;
        };
        listener.onMapsWith = [this](const std::string& robot, const std::string& topic) {
            const std::scoped_lock lock(m_mutex);
            m_mapsWith.push_back(robot + " " + topic);
        };
        m_mapping = std::make_unique<LiveMapping>(robots, "us", LiveSettings{}, listener, earlier);
    }
    void TearDown() override {
        if (m_mapping) m_mapping->close();
    }
    void publish(const std::string& robot, StreamRole role, const std::string& name, Sample sample) {
        Event event;
        event.received = m_time;
        event.robot = robot;
        event.role = role;
        event.topic = "/" + robot + "/" + name;
        event.sensor = role == StreamRole::Ranges ? "laser" : "";
        event.sample = std::move(sample);
        m_mapping->onEvent(event);
    }
    void stand(const std::string& robot, const Pose& baseInOdom) {
        OdometrySample odometry;
        odometry.header = {m_time, "odom"};
        odometry.childFrame = "base_link";
        odometry.baseInOdom = baseInOdom;
        publish(robot, StreamRole::Odometry, "odom", odometry);
    }
    /// Drives @p robot from the room's origin for @p seconds along an arc; odometry says 4 % too much.
    void drive(const std::string& robot, double seconds) {
        for (int i = 0; i <= static_cast<int>(seconds * 10.0); ++i) {
            m_time += 100ms;
            const double way = 0.025 * i;
            m_base = poseFrom({way, 0.05 * way * way, 0.0}, 0.0, 0.0, 0.1 * way);
            const Pose reported = poseFrom({0.04 * way, 0.0, 0.0}, 0.0, 0.0, 0.0) * m_base;
            stand(robot, reported);
            const Pose laser = m_base * Laser;
            const double heading = std::atan2(laser.linear()(1, 0), laser.linear()(0, 0));
            RangesSample turn;
            turn.header = {m_time, "laser"};
            turn.angleMin = -std::numbers::pi;
            turn.angleStep = 2.0 * std::numbers::pi / 720.0;
            turn.rangeMin = 0.1;
            turn.rangeMax = 12.0;
            for (int ray = 0; ray < 720; ++ray)
                turn.ranges.push_back(static_cast<float>(
                    rangeIn(laser.translation().head<2>(), heading + turn.angleMin + ray * turn.angleStep)));
            publish(robot, StreamRole::Ranges, "scan", turn);
        }
    }
    [[nodiscard]] std::vector<KeyScanSample> scans() {
        const std::scoped_lock lock(m_mutex);
        return m_scans;
    }
    /// Waits until all is worked on that came so far.
    void calm() {
        bool done = false;
        std::mutex mutex;
        m_mapping->whenCalm([&] {
            const std::scoped_lock lock(mutex);
            done = true;
        });
        ASSERT_TRUE(waitUntil([&] {
            const std::scoped_lock lock(mutex);
            return done;
        }));
    }

    std::mutex m_mutex;
    std::vector<KeyScanSample> m_scans;
    std::vector<ScanPose> m_poses;
    std::vector<std::string> m_mapsWith;
    Pose m_base = Pose::Identity();  ///< in the room
    Time m_time = Time(1'700'000'000s);
    std::unique_ptr<LiveMapping> m_mapping;
};

TEST_F(PlaneRobots, WhereThereIsNoScannerThePlaneLaserMakesTheMap) {
    begin({withLaser("rover")});
    drive("rover", 10.0);
    calm();
    ASSERT_GE(scans().size(), 6U) << "a key scan each 30 cm";
    EXPECT_EQ(m_mapsWith, std::vector<std::string>{"rover /rover/scan"}) << "it is said once";
    for (const KeyScanSample& one : scans()) EXPECT_TRUE(isPlaneScan(one.scan->points));
    const RobotInMap place = m_mapping->robots()->front();
    EXPECT_TRUE(place.certain);
    // The map begins at the laser, level.
    const Pose began = Laser;
    EXPECT_LT(distanceBetween(place.baseInMap, began.inverse() * m_base), 0.03);
    EXPECT_LT(angleBetween(place.baseInMap, began.inverse() * m_base), degrees(0.5));
}

TEST_F(PlaneRobots, ItsMapGoesOnWhenTheStationStartsAgain) {
    begin({withLaser("rover")});
    drive("rover", 4.0);
    calm();
    const EarlierMap earlier{scans(), m_poses};
    m_mapping->close();
    const std::size_t before = scans().size();
    begin({withLaser("rover")}, earlier);
    drive("rover", 10.0);
    calm();
    EXPECT_GT(scans().size(), before);
    const RobotInMap place = m_mapping->robots()->front();
    EXPECT_TRUE(place.certain) << place.how;
    EXPECT_LT(distanceBetween(place.baseInMap, Laser.inverse() * m_base), 0.03);
}

TEST_F(PlaneRobots, WhereAScannerMakesTheMapThePlaneLaserDoesNot) {
    begin({withScanner("kurt3d"), withLaser("rover")});
    stand("kurt3d", Pose::Identity());
    drive("rover", 30.0);
    calm();
    EXPECT_TRUE(scans().empty());
    EXPECT_TRUE(m_mapsWith.empty());
}

TEST_F(PlaneRobots, AScannerOfWhichNothingIsHeardIsWaitedForForTwentySeconds) {
    begin({withScanner("kurt3d"), withLaser("rover")});
    drive("rover", 19.0);
    calm();
    EXPECT_TRUE(scans().empty());
    drive("rover", 5.0);
    calm();
    EXPECT_FALSE(scans().empty());
}

TEST_F(PlaneRobots, ARobotWhoseFileHasCloudsThatNeverComeIsPlacedInTheMapOfOthers) {
    RobotDescription crawler = withLaser("rover");
    crawler.streams.push_back(stream("rover", StreamRole::Points, "points"));  // with another unit only
    begin({withScanner("kurt3d"), crawler});
    stand("kurt3d", Pose::Identity());
    drive("rover", 40.0);
    calm();
    EXPECT_TRUE(scans().empty());
    EXPECT_TRUE(m_mapsWith.empty());
}

TEST_F(PlaneRobots, AloneItMapsAfterTwentySeconds) {
    RobotDescription crawler = withLaser("rover");
    crawler.streams.push_back(stream("rover", StreamRole::Points, "points"));
    begin({crawler});
    drive("rover", 19.0);
    calm();
    EXPECT_TRUE(scans().empty());
    drive("rover", 5.0);
    calm();
    EXPECT_FALSE(scans().empty());
}

TEST_F(PlaneRobots, ALaserThatLooksAtTheGroundMakesNoMap) {
    RobotDescription rover = withLaser("rover");
    rover.sensors["laser"].sensorInBase = poseFrom({0.1, 0.0, 0.3}, 0.0, degrees(40), 0.0);
    begin({rover});
    drive("rover", 5.0);
    calm();
    EXPECT_TRUE(scans().empty());
}

TEST_F(PlaneRobots, AFileMayNameThePlaneLaser) {
    RobotDescription rover = withLaser("rover");
    rover.streams.front().maps = true;
    begin({withScanner("kurt3d"), rover});
    stand("kurt3d", Pose::Identity());
    drive("rover", 3.0);
    calm();
    EXPECT_FALSE(scans().empty());
}

TEST_F(PlaneRobots, BesideADepthCameraThePlaneLaserMakesTheMap) {
    RobotDescription rover = withLaser("rover");
    rover.streams.push_back(stream("rover", StreamRole::Points, "depth"));
    begin({rover});
    for (int i = 0; i < 5; ++i) {
        CloudSample ahead;
        ahead.header = {m_time, "camera"};
        for (int j = 0; j < 500; ++j)
            ahead.points.emplace_back(2.0F, 0.004F * static_cast<float>(j - 250),
                                      0.1F * static_cast<float>(j % 5));
        publish("rover", StreamRole::Points, "depth", ahead);
        drive("rover", 3.0);
    }
    calm();
    ASSERT_FALSE(scans().empty());
    EXPECT_EQ(m_mapsWith, std::vector<std::string>{"rover /rover/scan"});
    for (const KeyScanSample& one : scans()) EXPECT_TRUE(isPlaneScan(one.scan->points));
}

TEST_F(PlaneRobots, WithoutOdometryItMakesNone) {
    RobotDescription rover = withLaser("rover");
    rover.streams.pop_back();
    begin({rover});
    drive("rover", 3.0);
    calm();
    EXPECT_TRUE(scans().empty());
}

}  // namespace
}  // namespace leitstand::test
