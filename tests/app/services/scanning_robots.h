#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/mapping/live_mapping.h"
#include "core/event/motion_samples.h"
#include "core/event/scan_bodies.h"
#include "core/event/stream_role.h"
#include "core/mapping/placement/placement_format.h"
#include "core/robot/robot_description.h"
#include "tests/support/rooms.h"
#include "tests/support/wait.h"

namespace leitstand::test {

using namespace std::chrono_literals;

inline const Pose LaserInBase = poseFrom({0, 0, 0.9}, 0, 0, 0);
inline const Pose KurtBegins = poseFrom({-1.0, 0.5, 0}, 0, 0, 0);  ///< base_link in the room ...
inline const Pose Slot = KurtBegins * poseFrom({0, -0.8, 0}, 0, 0, 0);

inline RobotDescription scanning(const std::string& name) {
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
        listener.onBodies = [this](const ScanBodiesSample& bodies) {
            const std::scoped_lock lock(m_mutex);
            m_bodies.push_back(bodies);
        };
        listener.onLookedFor = [this](const std::string& robot, std::size_t) {
            const std::scoped_lock lock(m_mutex);
            m_vain.push_back(robot);
        };
        listener.onLoop = [this](const ScanLinksSample& question) {
            const std::scoped_lock lock(m_mutex);
            m_questions.push_back(question);
        };
        listener.onMap = [this](const LiveMapPtr& map) {
            const std::scoped_lock lock(m_mutex);
            m_map = map;
        };
        listener.onPlace = [this](const RobotPlaceSample& place) {
            const std::scoped_lock lock(m_mutex);
            m_places.push_back(place);
        };
        m_mapping = std::make_unique<LiveMapping>(std::vector{scanning("kurt3d"), scanning("crawler")}, "us",
                                                  LiveSettings{}, listener, earlier);
    }
    void TearDown() override { m_mapping->close(); }

    void publish(const std::string& robot, StreamRole role, Sample sample) {
        Event event;
        event.received = m_time;
        event.robot = robot;
        event.role = role;
        event.topic = role == StreamRole::Points ? "/" + robot + "/points" : "/" + robot + "/odom";
        event.sensor = role == StreamRole::Points ? "laser" : "";
        event.sample = std::move(sample);
        m_mapping->onEvent(event);
    }
    /// @p robot stands at @p baseInRoom, its odometry says @p baseInOdom, and looks around.
    void scan(const std::string& robot, const Pose& baseInRoom, const Pose& baseInOdom = Pose::Identity()) {
        stand(robot, baseInOdom);
        RoomSettings room = m_room;
        room.sensorInRoom = baseInRoom * LaserInBase;
        room.sweep = Sweep::Yawing;
        room.rows = m_dense ? 360 : 121;
        room.columns = m_dense ? 120 : 81;
        room.seed = ++m_seed;
        CloudSample cloud;
        cloud.header = {m_time, "laser"};
        for (const Eigen::Vector3f& point : scanRoom(room).scan.points) {
            if (point.allFinite()) cloud.points.push_back(point);
        }
        for (const Eigen::Vector3d& point : m_seen)
            cloud.points.push_back((room.sensorInRoom.inverse() * point).cast<float>());
        publish(robot, StreamRole::Points, std::move(cloud));
    }
    /// A break leaves a few points of a turn.
    void fragment(const std::string& robot, const Pose& baseInOdom) {
        stand(robot, baseInOdom);
        CloudSample cloud;
        cloud.header = {m_time, "laser"};
        for (int i = 0; i < 40; ++i) cloud.points.emplace_back(2.0F, 0.02F * static_cast<float>(i), 0.3F);
        publish(robot, StreamRole::Points, std::move(cloud));
    }
    /// @p robot is heard to stand where its odometry says @p baseInOdom.
    void stand(const std::string& robot, const Pose& baseInOdom, std::chrono::milliseconds time = 500ms) {
        for (auto passed = 0ms; passed < time; passed += 50ms) {
            m_time += 50ms;
            OdometrySample odometry;
            odometry.header = {m_time, "odom"};
            odometry.childFrame = "base_link";
            odometry.baseInOdom = baseInOdom;
            publish(robot, StreamRole::Odometry, odometry);
        }
    }
    /// Points of the outside of a robot at @p baseInRoom, in the room.
    [[nodiscard]] static std::vector<Eigen::Vector3d> outsideOf(const Pose& baseInRoom) {
        std::vector<Eigen::Vector3d> points;
        for (double z = 0.1; z < 0.45; z += 0.02) {
            for (double along = -0.18; along < 0.18; along += 0.01) {
                points.push_back(baseInRoom * Eigen::Vector3d(along, 0.15, z));
                points.push_back(baseInRoom * Eigen::Vector3d(along, -0.15, z));
            }
        }
        return points;
    }
    /// Points in the map where a robot at @p baseInRoom is seen.
    [[nodiscard]] std::size_t inMapAt(const Pose& baseInRoom) {
        const std::scoped_lock lock(m_mutex);
        std::size_t points = 0;
        for (const LiveKeyScan& one : m_map->scans) {
            for (const Eigen::Vector3f& point : one.scan->points) {
                const Eigen::Vector3d there =
                    inMap(baseInRoom).inverse() * (one.pose.scanInMap * point.cast<double>());
                if (there.z() > 0.1 && there.z() < 0.45 && std::abs(there.x()) < 0.2 &&
                    std::abs(there.y()) < 0.2)
                    ++points;
            }
        }
        return points;
    }
    [[nodiscard]] std::map<std::uint64_t, std::vector<BodyInScan>> bodies() {
        const std::scoped_lock lock(m_mutex);
        std::map<std::uint64_t, std::vector<BodyInScan>> all;
        for (const ScanBodiesSample& sample : m_bodies) {
            for (const BodiesOfScan& one : sample.scans) all[one.scan] = one.bodies;
        }
        return all;
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
    std::vector<ScanBodiesSample> m_bodies;
    std::vector<ScanLinksSample> m_questions;  ///< about places that were recognised
    std::vector<std::string> m_vain;           ///< were looked for, and not found
    LiveMapPtr m_map;
    std::vector<Eigen::Vector3d> m_seen;  ///< what scanners see beside the room, in the room
    RoomSettings m_room;                  ///< about the robots
    bool m_dense = false;                 ///< as many points as a real scanner has in a turn
    Time m_time = Time(1'700'000'000s);
    unsigned m_seed = 0;
    std::unique_ptr<LiveMapping> m_mapping;
};

}  // namespace leitstand::test
