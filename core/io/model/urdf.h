#pragma once

#include <string>

#include "core/base/result.h"
#include "core/robot/model/robot_model.h"

namespace leitstand {

/// Reads a robot's model from @p text, URDF as robot_state_publisher publishes it (wiki.ros.org/urdf/XML). It
/// may be hostile: its size, depth and numbers are limited. The error has @p name, the line and what was
/// expected. What the station does not draw (inertia, transmissions, sensors) is not read.
[[nodiscard]] Result<RobotModel> readUrdf(const std::string& text, const std::string& name);

}  // namespace leitstand
