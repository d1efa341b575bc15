#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/log/live_mission.h"
#include "app/services/log/mission_robots.h"
#include "app/services/places/mission_map.h"
#include "app/services/station/station_mapping.h"
#include "core/event/event.h"
#include "core/event/motion_samples.h"
#include "core/event/sample.h"
#include "core/event/stream_role.h"
#include "core/mission/state/scan_state.h"
#include "tests/support/rooms.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait.h"

namespace leitstand::test {

using namespace std::chrono_literals;

inline RobotDescription kurt() {
    RobotDescription robot;
    robot.letter = "K";
    robot.name = robot.title = "kurt3d";
    robot.baseFrame = "base_link";
    robot.odomFrame = "odom";
    robot.sensors["laser"].frame = "kurt3d/laser";
    robot.sensors["laser"].sensorInBase = poseFrom({0, 0, 0.9}, 0, 0, 0);
    StreamDescription points;
    points.topic = "/kurt3d/points";
    points.type = "sensor_msgs/msg/PointCloud2";
    points.sensor = "laser";
    robot.streams.push_back(points);
    return robot;
}

/// A station's mapping with its log, and a robot that drives through the furnished room.
class StationMappingTest : public testing::Test {
protected:
    void begin() {
        LiveMissionSettings settings;
        settings.folder = m_folder / "mission";
        settings.robots = {m_robot};
        settings.robots.front().file = m_robotFile;
        settings.station = "us";
        LiveMissionListener listener;
        listener.onEvent = [this](const Event& event) {
            if (StationMapping* const mapping = m_receives) mapping->onEvent(event);
        };
        auto earlier = keyScansOf(settings.folder);
        auto links = scanLinksOf(settings.folder);
        carryMapping(settings.folder, settings.robots);
        auto mission = LiveMission::open(settings, std::move(listener));
        ASSERT_TRUE(mission.ok()) << mission.error().text;
        m_mission = std::move(mission).value();
        StationMappingListener reported;
        reported.onMessage = [this](const std::string& text) {
            const std::scoped_lock lock(m_mutex);
            m_words += text + "\n";
        };
        reported.onScans = [this](const LiveMapPtr& map) { m_shown = map->scans.size(); };
        m_mapping = std::make_unique<StationMapping>(
            *m_mission, [this] { return m_granted.load(); },
            StationMappingSetup{settings.robots, settings.station, m_settings, std::move(earlier),
                                std::move(links), settings.folder},
            std::move(reported));
        m_receives = m_mapping.get();
    }
    void end() {
        m_mapping->close();
        m_receives = nullptr;
        m_mission.reset();
        m_mapping.reset();
    }
    void TearDown() override {
        if (m_mapping) end();
    }

    void publish(Sample sample, StreamRole role, const std::string& topic = "/kurt3d/points") {
        Event event;
        event.received = m_time;
        event.robot = "kurt3d";
        event.role = role;
        event.topic = role == StreamRole::Points ? topic : "/kurt3d/odom";
        event.sensor = role == StreamRole::Points ? "laser" : "";
        event.sample = std::move(sample);
        m_mapping->onEvent(event);
    }
    void odometry(const Pose& baseInOdom) {
        OdometrySample sample;
        sample.header = {m_time, "kurt3d/odom"};
        sample.childFrame = "kurt3d/base_link";
        sample.baseInOdom = baseInOdom;
        publish(sample, StreamRole::Odometry);
    }
    /// The robot drives on by 0.4 m and looks around; @p slip: its odometry is wrong by that.
    void scan(const Pose& slip = Pose::Identity()) {
        const Pose before = m_slip;
        for (int i = 0; i < 20; ++i) {
            m_time += 100ms;
            m_slip = before * interpolated(Pose::Identity(), slip, (i + 1) / 20.0);
            odometry(basePose(m_way + 0.4 * (i + 1) / 20.0) * m_slip);
        }
        m_way += 0.4;
        RoomSettings room;
        room.sensorInRoom = basePose(m_way) * poseFrom({0, 0, 0.9}, 0, 0, 0);
        room.sweep = Sweep::Yawing;
        room.rows = 121;
        room.columns = 81;
        room.seed = ++m_seed;
        CloudSample cloud;
        cloud.header = {m_time, "kurt3d/laser"};
        for (const Eigen::Vector3f& point : scanRoom(room).scan.points) {
            const auto tooFar = static_cast<float>(m_tooFar);
            if (point.allFinite()) cloud.points.push_back((1.0F + tooFar / point.norm()) * point);
        }
        publish(std::move(cloud), StreamRole::Points);
    }
    [[nodiscard]] Pose basePose(double way) const {
        if (!m_circles) return poseFrom({-1.8 + way, 0, 0}, 0, 0, 0);
        return poseFrom({-std::cos(way), -std::sin(way), 0}, 0, 0, way - M_PI / 2);  // of 1 m
    }
    /// The map meets itself where the robot drives in a circle of 6 m.
    void closeLoops() {
        m_circles = true;
        LoopSettings& loops = m_settings.loops;
        loops.on = true;
        loops.sameAge = 2.0;
        loops.about = loops.reach = 1.5;
        loops.apart = 0.3;
        loops.noticed = loops.noticedAngle = loops.previewed = loops.previewedAngle = 1e-5;
    }
    /// Drives until a loop closed, and what moved is in the log.
    [[nodiscard]] bool closesOne() {
        for (std::size_t i = m_mapping->scans()->scans.size() + 1; i <= 20; ++i) {
            scan();
            if (!scans(i)) return false;
            if (waitUntil([&] { return m_mapping->loop().has_value(); }, 300ms)) break;
        }
        return waitUntil([&] { return words().find("meets itself") != std::string::npos; }, 60s);
    }
    [[nodiscard]] std::vector<Pose> posesInLog() const {
        std::vector<Pose> poses;
        const MissionStatePtr mission = m_mission->state();
        for (const auto& [id, scan] : *mission->keyScans) poses.push_back(scan.pose.scanInMap);
        return poses;
    }
    [[nodiscard]] bool mapIsAsLogged() const {
        return waitUntil([&] {
            const LiveMapPtr map = m_mapping->scans();
            const auto logged = posesInLog();
            return map->scans.size() == logged.size() &&
                   std::equal(logged.begin(), logged.end(), map->scans.begin(),
                              [](const Pose& a, const LiveKeyScan& b) {
                                  return distanceBetween(a, b.pose.scanInMap) < 1e-9;
                              });
        });
    }

    [[nodiscard]] bool scans(std::size_t count) {
        return waitUntil([&] { return m_mapping->scans()->scans.size() >= count && logged() >= count; }, 60s);
    }
    [[nodiscard]] std::size_t logged() const { return m_mission->state()->keyScans->size(); }
    [[nodiscard]] ScanTrust trust(std::uint64_t id) const {
        return m_mapping->scans()->scans.at(id - 1).pose.trust;
    }
    [[nodiscard]] ScanTrust trustInLog(std::uint64_t id) const {
        return m_mission->state()->keyScans->at(id).pose.trust;
    }
    [[nodiscard]] bool becomes(std::uint64_t id, ScanTrust wanted) const {
        return waitUntil([&] { return trust(id) == wanted && trustInLog(id) == wanted; }, 60s);
    }
    [[nodiscard]] std::string words() {
        const std::scoped_lock lock(m_mutex);
        return m_words;
    }

    const TemporaryFolder m_folder;
    LiveSettings m_settings;
    double m_tooFar = 0.0;  ///< the scanner measures [m]
    std::filesystem::path m_robotFile = {};
    bool m_circles = false;
    std::atomic<bool> m_granted = true;
    std::atomic<std::size_t> m_shown = 0;
    std::mutex m_mutex;
    std::string m_words;
    Time m_time = Time(1'700'000'000s);
    Pose m_slip = Pose::Identity();
    double m_way = 0.0;
    unsigned m_seed = 0;
    RobotDescription m_robot = kurt();
    std::unique_ptr<LiveMission> m_mission;
    std::unique_ptr<StationMapping> m_mapping;
    std::atomic<StationMapping*> m_receives = nullptr;  ///< the same, for the thread of the log
};

}  // namespace leitstand::test
