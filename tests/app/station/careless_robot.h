#pragma once

#include <atomic>
#include <memory>
#include <thread>

#include "core/robot/robot_description.h"
#include "transport/dds/node.h"

namespace leitstand::test {

/// "rover", with a scanner in a plane.
[[nodiscard]] RobotDescription carelessRobot();

/// A robot without a watchdog in an empty hall: it does what it was told last, for ever.
class CarelessRobot {
public:
    CarelessRobot(Node& node, const RobotDescription& robot);  ///< throws when it cannot listen
    [[nodiscard]] double speed() const { return m_speed; }

private:
    void run(const std::stop_token& stop);

    RobotDescription m_robot;
    std::atomic<double> m_speed = 0.0;
    double m_x = 0.0;
    std::unique_ptr<Publisher> m_odometry, m_ranges;
    std::unique_ptr<Subscription> m_commands;
    std::jthread m_thread;
};

}  // namespace leitstand::test
