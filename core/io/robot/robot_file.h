#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Reads a robot's file (YAML; docs/robots.md lists the keys and their defaults).
///
/// The error is one text with a line for each mistake, in the order of the file: file, line, key, what was
/// expected and what was found.
[[nodiscard]] Result<RobotDescription> readRobot(const std::filesystem::path& file);
/// Parses a robot's file from @p text; errors call it @p name.
[[nodiscard]] Result<RobotDescription> parseRobot(std::string_view text, const std::string& name);

/// Returns @p robot as a file that readRobot() accepts and that people can edit.
[[nodiscard]] std::string writeRobot(const RobotDescription& robot);

/// Returns the robot's file @p text with @p correction for its sensor @p sensor. Everything else, also
/// comments, stays as written. Error when there is no such sensor, or when it is written in a way that is not
/// supported here. The correction must then be written by hand; errors call the file @p name.
[[nodiscard]] Result<std::string> withCorrection(const std::string& text, const std::string& name,
                                                 const std::string& sensor,
                                                 const ScannerCorrection& correction);
/// Returns the line of a robot's file that holds @p correction.
[[nodiscard]] std::string correctionLine(const ScannerCorrection& correction);

}  // namespace leitstand
