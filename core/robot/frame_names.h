#pragma once

#include <string>

#include "core/robot/robot_description.h"

namespace leitstand {

/// Returns the station's name for a robot's @p frame, according to the robot's TfPrefix. For Topic this is
/// "kurt3d/base_link", even if the robot does not use the prefix itself. For Frame and None it is @p frame. A
/// leading slash of old drivers is removed.
[[nodiscard]] std::string frameName(const RobotDescription& robot, const std::string& frame);

/// Whether a transform on a topic that robots share belongs to @p robot. For TfPrefix::Frame, the name of its
/// child or parent must begin with the robot's name. Otherwise every transform belongs to the robot.
[[nodiscard]] bool isOwnTransform(const RobotDescription& robot, const std::string& parent,
                                  const std::string& child);

}  // namespace leitstand
