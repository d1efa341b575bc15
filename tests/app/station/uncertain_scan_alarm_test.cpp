#include <algorithm>
#include <optional>

#include "app/session/station/station_alarms.h"
#include "app/session/station/station_mapping.h"
#include "core/mission/mission_state.h"
#include "core/robot/stream_defaults.h"
#include "tests/app/station/station_scene.h"
#include "tests/support/rooms.h"
#include "tests/transport/link/control_robot.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using State = AlarmSample::State;

RobotDescription scanningRobot() {
    RobotDescription robot = drivenRobot();
    robot.streams.push_back(defaultStream(StreamRole::Points, robot.name, "laser"));
    robot.sensors["laser"].sensorInBase = poseFrom({0, 0, 0.9}, 0, 0, 0);
    return robot;
}

/// A station whose mapping hears of a robot that drives through the furnished room, at times of its own.
class UncertainScanAlarm : public StationScene {
protected:
    void say(Sample sample, StreamRole role) {
        const StreamDescription& stream = *m_description.stream(role);
        Event event;
        event.received = m_time;
        event.robot = m_description.name;
        event.role = role;
        event.topic = stream.topic;
        event.sensor = stream.sensor;
        event.sample = std::move(sample);
        m_station->mapping().take(event);
    }
    /// It drives on by 0.4 m and looks around; @p slip: its odometry is wrong by that.
    void scan(const Pose& slip = Pose::Identity()) {
        const auto baseInRoom = [](double way) { return poseFrom({-1.8 + way, 0, 0}, 0, 0, 0); };
        for (int i = 1; i <= 20; ++i) {
            m_time += 100ms;
            OdometrySample odometry;
            odometry.header = {m_time, "odom"};
            odometry.childFrame = "base_link";
            odometry.baseInOdom =
                baseInRoom(m_way + 0.4 * i / 20.0) * interpolated(Pose::Identity(), slip, i / 20.0);
            say(odometry, StreamRole::Odometry);
        }
        m_way += 0.4;
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
        say(std::move(cloud), StreamRole::Points);
    }
    [[nodiscard]] bool scans(std::size_t count) {
        return waitUntil([&] { return m_station->mapping().scans()->scans.size() >= count; }, 60s);
    }
    [[nodiscard]] std::optional<Alarm> alarm() const {
        const auto all = m_station->alarms().view().alarms;
        const auto found = std::find_if(all.begin(), all.end(), [](const Alarm& one) {
            return one.cause.id.key == alarm_key::UncertainScan && !one.ended;
        });
        return found == all.end() ? std::nullopt : std::optional(*found);
    }
    /// As the mission has it.
    [[nodiscard]] std::optional<State> logged() const {
        const MissionStatePtr mission = m_station->mission();
        for (const auto& [id, state] : *mission->alarms) {
            if (std::get<2>(id) == alarm_key::UncertainScan) return state.alarm.state;
        }
        return std::nullopt;
    }
    [[nodiscard]] bool raised() {
        return waitUntil([&] { return alarm().has_value() && logged() == State::Raised; });
    }
    [[nodiscard]] bool ended() {
        return waitUntil([&] { return !alarm().has_value() && logged() == State::Cleared; });
    }

    const RobotDescription m_description = scanningRobot();
    Time m_time = Time(1'700'000'000s);
    double m_way = 0.0;
    unsigned m_seed = 0;
    std::unique_ptr<Station> m_station = stationFor({m_description});
};

TEST_F(UncertainScanAlarm, IsRaisedAndEndsWhenTheScanIsRejectedOrAccepted) {
    // Scans enter once the station holds the map's grant.
    ASSERT_TRUE(waitUntil([&] {
        const auto refused = m_station->mapping().reject(1);
        return !refused.ok() && refused.error().text.find("key scan 1") != std::string::npos;
    })) << words();
    scan();
    scan();
    ASSERT_TRUE(scans(2)) << words();
    scan(poseFrom({0.9, -0.7, 0}, 0, 0, degrees(25)));
    ASSERT_TRUE(scans(3)) << words();
    for (const LiveKeyScan& one : m_station->mapping().scans()->scans)
        EXPECT_EQ(one.counts(), one.id < 3) << one.id;
    ASSERT_TRUE(raised()) << words();
    EXPECT_EQ(alarm()->cause.severity, AlarmSeverity::Attention);
    EXPECT_EQ(alarm()->cause.value, 1.0) << "scans";

    ASSERT_TRUE(m_station->mapping().reject(3).ok());
    EXPECT_TRUE(ended()) << words();
    ASSERT_TRUE(m_station->mapping().undo().ok());
    EXPECT_TRUE(raised()) << "it is to be decided on again; " << words();
    ASSERT_TRUE(m_station->mapping().accept(3).ok());
    EXPECT_TRUE(ended()) << words();
    EXPECT_TRUE(m_station->mapping().scans()->scans.back().counts());
}

}  // namespace
}  // namespace leitstand::test
