#pragma once

#include <string>

#include "core/robot/robot_description.h"

namespace leitstand {

/// Returns the station's name for a robot's @p frame, by the robot's TfPrefix. For Topic this is
/// "kurt3d/base_link", whether the robot itself uses the prefix or not; for Frame and None it is @p frame. A
/// leading slash of old drivers is removed.
[[nodiscard]] std::string frameName(const RobotDescription& robot, const std::string& frame);

/// Whether a transform on a topic that robots share belongs to @p robot. For TfPrefix::Frame, its child or
/// parent must be named after the robot; otherwise every transform belongs to it.
[[nodiscard]] bool isOwnTransform(const RobotDescription& robot, const std::string& parent,
                                  const std::string& child);

}  // namespace leitstand
