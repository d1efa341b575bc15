#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Error: messages of a stream's type do not have one of its readings, or nobody knows that type.
[[nodiscard]] Result<void> checkReadings(const RobotDescription& robot);

/// Reads the robots' files @p files: paths, or names of shipped robots. Errors name the file.
[[nodiscard]] Result<std::vector<RobotDescription>> chooseRobots(const std::vector<std::string>& files);

/// Opens the robot called @p robot from @p file from now on. @p files: what @p robots were opened from, in
/// their order. A name stays if it means that file by now.
void useFile(std::vector<std::string>& files, const std::vector<RobotDescription>& robots,
             const std::string& robot, const std::string& file);

/// Checks that the robot in @p file can work together with @p team. Errors say what prevents it.
[[nodiscard]] Result<void> checkJoins(const std::string& file, std::vector<RobotDescription> team);

/// Writes a first file for @p robot, which is known only from its topics, to the user's folder. An existing
/// file of that name is kept. Gives the robot a letter that no robot of @p team has. Returns the path of the
/// file. Errors name it.
[[nodiscard]] Result<std::string> writeFirstFile(RobotDescription robot,
                                                 const std::vector<RobotDescription>& team);

}  // namespace leitstand
