#include <gmock/gmock.h>

#include "app/services/station/safety/station_alarms.h"
#include "core/event/stream_role.h"
#include "core/robot/streams/stream_defaults.h"
#include "tests/app/station/station_scene.h"
#include "tests/support/dds/quiet_robot.h"
#include "tests/transport/link/control_robot.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

/// A robot that tells its mode, of its streams only joints, once it is told to, and never odometry.
class HalfHeardRobot {
public:
    HalfHeardRobot(const TestDomain& domain, const RobotDescription& robot)
        : m_quiet(domain, robot), m_node(nodeIn(domain, {.name = robot.name})) {
        const StreamDescription& mode = *robot.stream(StreamRole::Mode);
        const StreamDescription& joints = *robot.stream(StreamRole::Joints);
        m_mode = must(m_node->publisher({mode.topic, mode.type, mode.qos}));
        m_joints = must(m_node->publisher({joints.topic, joints.type, joints.qos}));
    }
    void speak() { static_cast<void>(m_mode->write(testPayload(60, 1))); }
    void tellJoints() { static_cast<void>(m_joints->write(testPayload(60, 1))); }
    std::size_t seen() { return m_quiet.seen(); }

private:
    QuietRobot m_quiet;
    std::unique_ptr<Node> m_node;
    std::unique_ptr<Publisher> m_mode, m_joints;
};

RobotDescription robotWithMode() {
    RobotDescription robot = drivenRobot();
    for (const StreamRole role : {StreamRole::Mode, StreamRole::Joints})
        robot.streams.push_back(defaultStream(role, robot.name, {}));
    return robot;
}

class StationHearing : public StationScene {};

TEST_F(StationHearing, ARobotThatIsAnnouncedAndSaysNothingIsToldAndTheStationJoinsAnew) {
    const RobotDescription description = drivenRobot();
    QuietRobot robot(m_domain, description);
    auto station = stationFor({description});
    station->requestGrant("kurt3d");
    ASSERT_TRUE(waitUntil([&] { return station->robot("kurt3d").grant.mine; }));
    ASSERT_TRUE(waitUntil([&] { return station->robot("kurt3d").reception.has_value(); }));
    EXPECT_EQ(station->robot("kurt3d").reception->names, std::vector<std::string>{"/kurt3d/odom"});
    ASSERT_TRUE(waitUntil([&] { return robot.seen() == 2U; })) << words();
    EXPECT_THAT(words(), HasSubstr("announced, but nothing comes: /kurt3d/odom"));
    EXPECT_THAT(words(), HasSubstr("joining the network again"));
    ASSERT_TRUE(waitUntil([&] {
        const std::vector<Alarm> alarms = station->alarms().view().alarms;
        return std::any_of(alarms.begin(), alarms.end(),
                           [](const Alarm& one) { return one.cause.id.key == alarm_key::NotReceived; });
    }));
    EXPECT_TRUE(station->robot("kurt3d").grant.mine) << "what it holds it goes on holding";
    ASSERT_TRUE(waitUntil([&] {
        robot.speak();
        return station->robot("kurt3d").link.state != LinkState::NeverSeen;
    }));
    EXPECT_TRUE(waitUntil([&] { return !station->robot("kurt3d").reception.has_value(); }));
    EXPECT_TRUE(station->robot("kurt3d").grant.mine);
}

TEST_F(StationHearing, ARobotThatTellsItsModeOnlyIsNotHeardAndAStreamThatNeverComesIsNamed) {
    const RobotDescription description = robotWithMode();
    HalfHeardRobot robot(m_domain, description);
    auto station = stationFor({description});
    ASSERT_TRUE(waitUntil([&] {
        robot.speak();
        return station->robot("kurt3d").link.state == LinkState::Connected;
    })) << words();
    ASSERT_TRUE(waitUntil([&] {
        robot.speak();
        return robot.seen() == 3U;
    })) << "the station, the robot's other node, and the station once more: "
        << words();
    EXPECT_THAT(words(), HasSubstr("announced, but nothing comes: /kurt3d/joint_states, /kurt3d/odom"));
    ASSERT_TRUE(waitUntil([&] {
        robot.tellJoints();
        return words().find("announced, but never came: /kurt3d/odom; joining the network again") !=
               std::string::npos;
    })) << words();
    ASSERT_TRUE(waitUntil([&] {
        robot.tellJoints();
        return words().find("never came: /kurt3d/odom; is the sensor switched on?") != std::string::npos;
    })) << words();
    const auto reception = station->robot("kurt3d").reception;
    ASSERT_TRUE(reception);
    EXPECT_EQ(reception->names, std::vector<std::string>{"/kurt3d/odom"});
}

TEST_F(StationHearing, NobodyJoinsAnewWhileARobotMoves) {
    const RobotDescription moving = drivenRobot(), quiet = drivenRobot("crawler");
    const auto node = nodeIn(m_domain);
    ControlRobot robot(*node, moving);
    auto station = stationFor({moving, quiet});
    ASSERT_TRUE(drive(*station, "kurt3d", {0.3, 0.0, 0.0}, [&] { return robot.speed() > 0.2; })) << words();
    QuietRobot silent(m_domain, quiet);
    const auto until = std::chrono::steady_clock::now() + 4s;
    std::size_t seen = 0;
    ASSERT_TRUE(waitUntil([&] {
        station->setStick({0.3, 0.0, 0.0});
        seen = silent.seen();
        return std::chrono::steady_clock::now() > until && station->robot("crawler").reception.has_value();
    }));
    EXPECT_EQ(seen, 2U) << "the station as it came, and the other robot";
    EXPECT_GT(robot.speed(), 0.2);
    station->setDriveFocus({});
    EXPECT_TRUE(waitUntil([&] { return silent.seen() == 3U; })) << words();
}

TEST_F(StationHearing, AStopStandsAfterJoiningAnewUnderItsNumber) {
    const RobotDescription stopped = drivenRobot(), quiet = drivenRobot("crawler");
    const auto node = nodeIn(m_domain);
    ControlRobot robot(*node, stopped);
    auto station = stationFor({stopped, quiet});
    ASSERT_TRUE(waitUntil([&] { return station->robot("kurt3d").link.state == LinkState::Connected; }));
    station->stop("kurt3d");
    ASSERT_TRUE(waitUntil([&] { return station->robot("kurt3d").stop.standing; }));
    QuietRobot silent(m_domain, quiet);
    ASSERT_TRUE(waitUntil([&] { return silent.seen() == 3U; })) << words();
    ASSERT_TRUE(waitUntil([&] { return station->robot("kurt3d").link.state == LinkState::Connected; }));
    const StopStatus stop = station->robot("kurt3d").stop;
    EXPECT_TRUE(stop.sent && stop.acknowledged && stop.stopped);
    station->requestGrant("kurt3d");
    ASSERT_TRUE(waitUntil([&] { return station->release("kurt3d").ok(); }));
    EXPECT_TRUE(waitUntil([&] { return !station->robot("kurt3d").stop.stopped; })) << "by its next number";
}

}  // namespace
}  // namespace leitstand::test
