#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>

#include "core/robot/robot_description.h"
#include "tests/transport/link/control_robot.h"
#include "transport/dds/node.h"

namespace leitstand::test {

/// drivenRobot() with a camera and a scanner in a plane, or one of them.
[[nodiscard]] RobotDescription seeingRobot(bool camera = true, bool scanner = true,
                                           const std::string& name = "kurt3d");

/// A ControlRobot that also sends pictures and scans, 20 of each a second, as it is told.
class SeeingRobot {
public:
    enum class Pictures { Live, Frozen, Off };

    SeeingRobot(Node& node, const RobotDescription& robot);

    std::atomic<Pictures> pictures = Pictures::Live;  ///< frozen: one picture under ever new stamps
    std::atomic<bool> scans = true;
    [[nodiscard]] double speed() const { return m_drive.speed(); }
    [[nodiscard]] ControlRobot& drive() { return m_drive; }

private:
    void run(const std::stop_token& stop);

    RobotDescription m_robot;
    ControlRobot m_drive;
    std::unique_ptr<Publisher> m_camera, m_scanner;
    std::jthread m_thread;  ///< last: joined first
};

}  // namespace leitstand::test
