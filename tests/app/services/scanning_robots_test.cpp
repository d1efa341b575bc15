#include <algorithm>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/mapping/live_mapping.h"
#include "core/mapping/placement/placement_says.h"
#include "core/robot/robot_description.h"
#include "tests/support/rooms.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

const Pose LaserInBase = poseFrom({0, 0, 0.9}, 0, 0, 0);
const Pose KurtBegins = poseFrom({-1.0, 0.5, 0}, 0, 0, 0);  ///< base_link in the room ...
const Pose Slot = KurtBegins * poseFrom({0, -0.8, 0}, 0, 0, 0);

RobotDescription scanning(const std::string& name) {
    RobotDescription robot;
    robot.name = name;
    robot.title = name;
    robot.baseFrame = "base_link";
    robot.odomFrame = "odom";
    robot.footprint = {{0.2, 0.15}, {-0.2, 0.15}, {-0.2, -0.15}, {0.2, -0.15}};
    robot.height = 0.5;
    robot.sensors["laser"].sensorInBase = LaserInBase;
    StreamDescription points;
    points.topic = "/" + name + "/points";
    robot.streams.push_back(points);
    return robot;
}

/// A station's mapping, and two robots with 3D scanners and no others in the furnished room.
class ScanningRobots : public testing::Test {
protected:
    void begin(const EarlierMap& earlier = {}) {
        LiveMappingListener listener;
        listener.onUpdate = [this](const MapUpdate& update) {
            const std::scoped_lock lock(m_mutex);
            if (update.keyScan) m_scans.push_back(*update.keyScan);
            if (update.poses) m_poses = update.poses->poses;
        };
        listener.onPlace = [this](const RobotPlaceSample& place) {
            const std::scoped_lock lock(m_mutex);
            m_places.push_back(place);
        };
        m_mapping = std::make_unique<LiveMapping>(std::vector{scanning("kurt3d"), scanning("crawler")}, "us",
                                                  LiveSettings{}, listener, earlier);
    }
    void TearDown() override { m_mapping->end(); }

    void say(const std::string& robot, StreamRole role, Sample sample) {
        Event event;
        event.received = m_time;
        event.robot = robot;
        event.role = role;
        event.topic = role == StreamRole::Points ? "/" + robot + "/points" : "/" + robot + "/odom";
        event.sensor = role == StreamRole::Points ? "laser" : "";
        event.sample = std::move(sample);
        m_mapping->take(event);
    }
    /// @p robot stands at @p baseInRoom, its odometry says @p baseInOdom, and looks around.
    void scan(const std::string& robot, const Pose& baseInRoom, const Pose& baseInOdom = Pose::Identity()) {
        for (int i = 0; i < 10; ++i) {
            m_time += 50ms;
            OdometrySample odometry;
            odometry.header = {m_time, "odom"};
            odometry.childFrame = "base_link";
            odometry.baseInOdom = baseInOdom;
            say(robot, StreamRole::Odometry, odometry);
        }
        RoomSettings room;
        room.sensorInRoom = baseInRoom * LaserInBase;
        room.sweep = Sweep::Yawing;
        room.rows = 121;
        room.columns = 81;
        room.seed = ++m_seed;
        CloudSample cloud;
        cloud.header = {m_time, "laser"};
        for (const Eigen::Vector3f& point : scanRoom(room).scan.points) {
            if (point.allFinite()) cloud.points.push_back(point);
        }
        say(robot, StreamRole::Points, std::move(cloud));
    }
    [[nodiscard]] bool enters(const std::string& robot) {
        return waitUntil(
            [&] {
                const std::scoped_lock lock(m_mutex);
                return std::any_of(m_scans.begin(), m_scans.end(),
                                   [&](const KeyScanSample& one) { return one.scan->robot == robot; });
            },
            60s);
    }
    [[nodiscard]] RobotInMap placeOf(const std::string& robot) const {
        const RobotsInMapPtr robots = m_mapping->robots();
        return *std::find_if(robots->begin(), robots->end(),
                             [&](const RobotInMap& one) { return one.robot == robot; });
    }
    /// The map begins at Kurt3D's scanner.
    [[nodiscard]] static Pose inMap(const Pose& baseInRoom) {
        return (KurtBegins * LaserInBase).inverse() * baseInRoom;
    }
    [[nodiscard]] bool stands(const std::string& robot, const Pose& baseInRoom) const {
        return waitUntil(
            [&] {
                const RobotInMap place = placeOf(robot);
                return place.certain && distanceBetween(place.baseInMap, inMap(baseInRoom)) < 0.05;
            },
            20s);
    }

    std::mutex m_mutex;
    std::vector<KeyScanSample> m_scans;
    std::vector<ScanPose> m_poses;
    std::vector<RobotPlaceSample> m_places;
    Time m_time = Time(1'700'000'000s);
    unsigned m_seed = 0;
    std::unique_ptr<LiveMapping> m_mapping;
};

TEST_F(ScanningRobots, TheSecondOneEntersFromItsSlotAlsoWhenTheStationStartsAgain) {
    begin();
    scan("kurt3d", KurtBegins);
    ASSERT_TRUE(enters("kurt3d"));
    const EarlierMap earlier{m_scans, m_poses};
    scan("crawler", Slot);
    EXPECT_TRUE(enters("crawler"));
    EXPECT_TRUE(stands("crawler", Slot));
    m_mapping->end();
    m_scans.clear();
    begin(earlier);  // it was left before the second one came
    scan("crawler", Slot);
    EXPECT_TRUE(enters("crawler"));
    EXPECT_TRUE(stands("crawler", Slot));
}

TEST_F(ScanningRobots, OneThatDroveOnWhileTheStationWasAwayIsFoundWhereItsOdometryWentTo) {
    begin();
    scan("kurt3d", KurtBegins);
    ASSERT_TRUE(enters("kurt3d"));
    EarlierMap earlier{m_scans, m_poses};
    RobotPlaceSample place;  // as the log has it; none of its scans came in
    place.robot = "crawler";
    place.cause = RobotPlaceSample::Cause::Operator;
    place.measured = m_time;
    place.baseInMap = place.odomInMap = inMap(Slot);
    place.certain = true;
    place.certainty = 0.9;
    earlier.places.emplace("crawler", place);
    m_mapping->end();
    m_scans.clear();
    begin(earlier);
    const Pose way = poseFrom({2.2, 0.2, 0}, 0, 0, degrees(70));
    m_time += 60s;
    scan("crawler", Slot * way, way);
    EXPECT_TRUE(enters("crawler"));
    EXPECT_TRUE(stands("crawler", Slot * way)) << placeOf("crawler").how;
}

TEST_F(ScanningRobots, WhereTheOperatorPutTheOneThatMakesTheMapIsInTheLog) {
    begin();
    scan("kurt3d", KurtBegins);
    ASSERT_TRUE(enters("kurt3d"));
    const Pose put = inMap(KurtBegins * poseFrom({0.4, 0.1, 0}, 0, 0, degrees(5)));
    m_mapping->place("kurt3d", put);
    ASSERT_TRUE(waitUntil([&] {
        const std::scoped_lock lock(m_mutex);
        return !m_places.empty();
    }));
    EXPECT_EQ(m_places.front().robot, "kurt3d");
    EXPECT_EQ(m_places.front().cause, RobotPlaceSample::Cause::Operator);
    EXPECT_TRUE(m_places.front().baseInMap.isApprox(put));
    EXPECT_FALSE(m_places.front().certain);
    EXPECT_EQ(m_places.front().how, placement_says::PutUntilScan);
    EXPECT_EQ(m_places.front().measured, m_time);
    const Pose there = KurtBegins * poseFrom({0.5, 0, 0}, 0, 0, 0);
    scan("kurt3d", there);  // carried: its odometry does not know of it
    EXPECT_TRUE(stands("kurt3d", there));
}

}  // namespace
}  // namespace leitstand::test
