#pragma once

#include <string>

#include "core/robot/robot_description.h"

namespace leitstand {

/// The name of a robot's @p frame among those of all robots, after its TfPrefix: "kurt3d/base_link" for
/// Topic, whether the robot itself says so or not; as it is for Frame and None. A leading slash of old
/// drivers goes.
[[nodiscard]] std::string frameName(const RobotDescription& robot, const std::string& frame);

/// Whether a transform on a topic that robots share is of @p robot: for Frame, when its child or parent is
/// named after the robot.
[[nodiscard]] bool isOwnTransform(const RobotDescription& robot, const std::string& parent,
                                  const std::string& child);

}  // namespace leitstand
