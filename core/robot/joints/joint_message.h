#pragma once

#include <string>

#include "core/event/sample.h"
#include "core/robot/joints/joint_control.h"

namespace leitstand {

/// Returns the command of @p setpoints to the joints of @p group, for a stream of the ROS type @p type. A
/// JointState names them, a Float64MultiArray has the group's order. A JointTrajectory has one point, to be
/// reached within the time of two commands.
[[nodiscard]] Sample jointMessage(const JointGroup& group, const JointSetpoints& setpoints,
                                  const std::string& type);

}  // namespace leitstand
