#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>

#include "core/robot/robot_description.h"
#include "transport/dds/node.h"
#include "transport/link/robot_side.h"

namespace leitstand::test {

/// "kurt3d" as design section 4 has it, as far as it concerns driving and stopping.
[[nodiscard]] RobotDescription drivenRobot(const std::string& name = "kurt3d");

/// A robot that moves at once as it is commanded, and says so in its odometry at 50 Hz.
class ControlRobot {
public:
    ControlRobot(Node& node, const RobotDescription& robot);  ///< throws when it cannot listen
    ~ControlRobot();
    ControlRobot(const ControlRobot&) = delete;
    ControlRobot& operator=(const ControlRobot&) = delete;

    [[nodiscard]] RobotCommands& commands() { return *m_commands; }
    [[nodiscard]] double speed() const { return m_commands->commanded().forward; }

private:
    void run(const std::stop_token& stop);

    RobotDescription m_robot;
    std::unique_ptr<Publisher> m_odometry;
    std::unique_ptr<RobotCommands> m_commands;
    std::jthread m_thread;
};

}  // namespace leitstand::test
