#pragma once

#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/event/motion_samples.h"
#include "core/event/sample.h"
#include "core/robot/robot_description.h"

namespace leitstand::simulation {

/// Stands for the controllers of ros2_control that move a stock robot's flippers and arm: joints follow
/// trajectories, positions or velocities at their rates, within their limits. As the real ones, they go on
/// with a velocity until they get another. They move nothing of the robot's body.
class StockJoints {
public:
    explicit StockJoints(const RobotDescription& robot);

    /// Takes a command to the group called @p group; of others, and of wrong size: none.
    void receive(const std::string& group, const Sample& command);
    /// Moves all joints up to @p now; with @p powered false, they stand and forget their commands.
    void step(Time now, bool powered);
    /// Adds the joints to what the robot says about its own.
    void addTo(JointSample& joints) const;

private:
    struct Joint {
        MovedJoint described;
        std::string group;
        double position = 0.0, velocity = 0.0;
        bool aims = false;    ///< whether it goes to the target, otherwise at a velocity
        double target = 0.0;  ///< [rad, m]
        double within = 0.0;  ///< time left to the target [s]
        double speed = 0.0;   ///< the commanded one [rad/s, m/s]
    };
    [[nodiscard]] Joint* find(const std::string& group, const std::string& name);
    static void aim(Joint& joint, double target, double within);

    std::vector<Joint> m_joints;
    Time m_now{};
};

}  // namespace leitstand::simulation
