#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Reads the robots of @p files: paths, or names of shipped ones. Errors name the file.
[[nodiscard]] Result<std::vector<RobotDescription>> chooseRobots(const std::vector<std::string>& files);

/// Checks that the robot of @p file can work beside @p team. Errors name the obstacle.
[[nodiscard]] Result<void> checkJoins(const std::string& file, std::vector<RobotDescription> team);

/// Writes a first file for @p robot, which is known only by its topics, into the user's folder, unless a file
/// of that name exists. Gives the robot a letter that none of @p team has. Returns the path of the file.
/// Errors name it.
[[nodiscard]] Result<std::string> writeFirstFile(RobotDescription robot,
                                                 const std::vector<RobotDescription>& team);

}  // namespace leitstand
