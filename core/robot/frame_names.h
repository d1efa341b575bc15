#pragma once

#include <string>

#include "core/robot/robot_description.h"

namespace leitstand {

/// Returns the name of a robot's @p frame among those of all robots, after its TfPrefix. For Topic this is
/// "kurt3d/base_link", whether the robot itself uses it or not; for Frame and None it is @p frame. A leading
/// slash of old drivers is removed.
[[nodiscard]] std::string frameName(const RobotDescription& robot, const std::string& frame);

/// Whether a transform on a topic that robots share belongs to @p robot. For Frame, it does when its child or
/// parent is named after the robot.
[[nodiscard]] bool isOwnTransform(const RobotDescription& robot, const std::string& parent,
                                  const std::string& child);

}  // namespace leitstand
