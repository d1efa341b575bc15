#include "tests/transport/link/control_robot.h"

#include <chrono>

#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "core/robot/streams/stream_defaults.h"
#include "tests/transport/dds/test_node.h"
#include "transport/convert/encode.h"

namespace leitstand::test {

RobotDescription drivenRobot(const std::string& name) {
    RobotDescription robot;
    robot.letter = std::string(1, 'K');
    robot.name = name;
    robot.title = name;
    robot.baseFrame = "base_link";
    robot.odomFrame = "odom";
    robot.footprint = {{0.3, 0.2}, {-0.3, 0.2}, {-0.3, -0.2}, {0.3, -0.2}};
    robot.maxSpeed = 0.5;
    robot.maxTurnRate = 1.0;
    for (const StreamRole role :
         {StreamRole::Odometry, StreamRole::DriveCommand, StreamRole::StopCommand, StreamRole::StopState}) {
        robot.streams.push_back(defaultStream(role, name, {}));
    }
    return robot;
}

ControlRobot::ControlRobot(Node& node, const RobotDescription& robot) : m_robot(robot) {
    const StreamDescription& odometry = *robot.stream(StreamRole::Odometry);
    m_odometry = must(node.publisher({odometry.topic, odometry.type, odometry.qos, Flow::Immediate}));
    m_commands = must(RobotCommands::create(node, robot));
    m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

ControlRobot::~ControlRobot() = default;

void ControlRobot::run(const std::stop_token& stop) {
    auto next = std::chrono::steady_clock::now();
    while (!stop.stop_requested()) {
        const DriveVelocity velocity = m_commands->commanded();
        m_commands->moved(velocity.forward, velocity.turn);
        OdometrySample sample;
        sample.header = {std::chrono::system_clock::now(), m_robot.odomFrame};
        sample.childFrame = m_robot.baseFrame;
        sample.linear.x() = velocity.forward;
        sample.angular.z() = velocity.turn;
        static_cast<void>(m_odometry->write(must(encode(sample, "nav_msgs/msg/Odometry"))));
        next += std::chrono::milliseconds(20);
        std::this_thread::sleep_until(next);
    }
}

}  // namespace leitstand::test
