#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/event/motion_samples.h"
#include "core/robot/robot_description.h"
#include "robots/hardware/robot_hardware.h"
#include "robots/simulation/world/world.h"
#include "transport/dds/node.h"
#include "transport/services/navigation_server.h"

namespace leitstand::simulation {

/// Stands for Nav2 on a stock robot: it takes goals by the action NavigateToPose and drives to them in a
/// straight line, seeing nothing. It gives up where it does not get on.
class StockNavigation {
public:
    /// Null: the robot's file names no such action. Errors name the topic.
    [[nodiscard]] static Result<std::unique_ptr<StockNavigation>> create(Node& node,
                                                                         const RobotDescription& robot);

    /// Returns the command to drive now; empty: it does not drive. @p sent: what the robot just sent, its
    /// odometry among it.
    [[nodiscard]] std::optional<TwistSample> step(Time now, const std::vector<HardwareSample>& sent);

private:
    struct Goal {
        NavigationGoal asked;
        double nearest = 0.0;  ///< smallest distance so far [m]
        Time gotOn{};          ///< when that was reached
    };
    [[nodiscard]] std::optional<TwistSample> steer(Goal& goal, Time now);
    void end(GoalTracker::Status status);  // under the mutex

    RobotDescription m_robot;
    Time m_progressDue{};
    std::optional<OdometrySample> m_odometry;
    std::mutex m_mutex;  ///< guards what follows
    std::optional<Goal> m_goal;
    std::optional<GoalTracker::Report> m_last;   ///< of the goal before
    std::unique_ptr<NavigationServer> m_server;  ///< last: destroyed first
};

}  // namespace leitstand::simulation
