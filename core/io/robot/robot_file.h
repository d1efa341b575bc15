#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Reads a robot's file (YAML; docs/robots.md lists the keys and their defaults). The error is one text with
/// a line for each mistake, in the order of the file. A line names file, line, key, what was expected and
/// what was found.
[[nodiscard]] Result<RobotDescription> readRobot(const std::filesystem::path& file);
/// Parses the @p text of a robot's file; errors call the file @p name.
[[nodiscard]] Result<RobotDescription> parseRobot(std::string_view text, const std::string& name);

/// Returns @p robot as the text of a file that readRobot() accepts and that people can edit.
[[nodiscard]] std::string writeRobot(const RobotDescription& robot);

}  // namespace leitstand
