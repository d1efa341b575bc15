#pragma once

#include <utility>
#include <vector>

#include "app/services/station/station_mapping.h"
#include "core/event/event.h"
#include "core/event/motion_samples.h"
#include "core/event/sample.h"
#include "core/event/stream_role.h"
#include "core/robot/streams/stream_defaults.h"
#include "tests/app/station/station_scene.h"
#include "tests/support/rooms.h"
#include "tests/transport/link/control_robot.h"

namespace leitstand::test {

[[nodiscard]] inline RobotDescription scanningRobot() {
    RobotDescription robot = drivenRobot();
    robot.streams.push_back(defaultStream(StreamRole::Points, robot.name, "laser"));
    robot.sensors["laser"].sensorInBase = poseFrom({0, 0, 0.9}, 0, 0, 0);
    return robot;
}

/// Stations whose mappings hear of a robot that drives through the furnished room, at times of its own.
class ScanningScene : public StationScene {
protected:
    void publish(Sample sample, StreamRole role) {
        const StreamDescription& stream = *m_description.stream(role);
        Event event;
        event.received = m_time;
        event.robot = m_description.name;
        event.role = role;
        event.topic = stream.topic;
        event.sensor = stream.sensor;
        event.sample = std::move(sample);
        for (Station* station : m_hearing) station->mapping().onEvent(event);
    }
    /// It drives on by @p way [m] and looks around; @p slip: its odometry is wrong by that from then on.
    void scan(const Pose& slip = Pose::Identity(), double way = 0.4) {
        const auto baseInRoom = [](double way) { return poseFrom({-1.8 + way, 0, 0}, 0, 0, 0); };
        const Pose before = m_slip;
        for (int i = 1; i <= 20; ++i) {
            m_time += std::chrono::milliseconds(100);
            m_slip = before * interpolated(Pose::Identity(), slip, i / 20.0);
            OdometrySample odometry;
            odometry.header = {m_time, "odom"};
            odometry.childFrame = "base_link";
            odometry.baseInOdom = baseInRoom(m_way + way * i / 20.0) * m_slip;
            publish(odometry, StreamRole::Odometry);
        }
        m_way += way;
        RoomSettings room;
        room.sensorInRoom = baseInRoom(m_way) * poseFrom({0, 0, 0.9}, 0, 0, 0);
        room.sweep = Sweep::Yawing;
        room.rows = 121;
        room.columns = 81;
        room.seed = ++m_seed;
        CloudSample cloud;
        cloud.header = {m_time, "laser"};
        for (const Eigen::Vector3f& point : scanRoom(room).scan.points) {
            if (point.allFinite()) cloud.points.push_back(point);
        }
        publish(std::move(cloud), StreamRole::Points);
    }
    /// Whether @p station may register: scans enter once it holds the map's grant.
    [[nodiscard]] static bool holdsMap(Station& station) {
        return waitUntil([&] {
            const auto refused = station.mapping().reject(4711);
            return !refused.ok() && refused.error().text.find("key scan 4711") != std::string::npos;
        });
    }

    const RobotDescription m_description = scanningRobot();
    std::vector<Station*> m_hearing;
    Time m_time = Time(std::chrono::seconds(1'700'000'000));
    Pose m_slip = Pose::Identity();
    double m_way = 0.0;
    unsigned m_seed = 0;
};

}  // namespace leitstand::test
