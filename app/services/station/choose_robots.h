#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// The robots of @p files: paths, or names of shipped ones. Errors name the file.
[[nodiscard]] Result<std::vector<RobotDescription>> chooseRobots(const std::vector<std::string>& files);

/// Whether the robot of @p file can work beside @p team. Errors name what is in the way.
[[nodiscard]] Result<void> checkJoins(const std::string& file, std::vector<RobotDescription> team);

/// Writes a first file of @p robot, which was only heard, among the user's own, unless there is one of its
/// name already; its letter is none of @p team's. Returns the file. Errors name it.
[[nodiscard]] Result<std::string> writeFirstFile(RobotDescription robot,
                                                 const std::vector<RobotDescription>& team);

}  // namespace leitstand
