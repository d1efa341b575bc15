#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Reads a robot's file (YAML; docs/robots.md lists the keys and their defaults).
///
/// What is wrong is told in one text, a line for each error, in the order of the file: file, line, key,
/// what was expected and what stands there.
[[nodiscard]] Result<RobotDescription> readRobot(const std::filesystem::path& file);
/// The same from @p text; errors call it @p name.
[[nodiscard]] Result<RobotDescription> parseRobot(std::string_view text, const std::string& name);

/// @p robot as a file that readRobot() takes, for people to go on with.
[[nodiscard]] std::string writeRobot(const RobotDescription& robot);

}  // namespace leitstand
