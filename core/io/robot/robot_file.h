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

/// Returns @p text, which is a robot's file, with @p correction for the sensor @p sensor. Everything else
/// stays as written, comments included. Error when there is no such sensor, or when the file writes it in a
/// way that is not supported here. A person must then write the correction. Errors call the file @p name.
[[nodiscard]] Result<std::string> withCorrection(const std::string& text, const std::string& name,
                                                 const std::string& sensor,
                                                 const ScannerCorrection& correction);
/// Returns the line of a robot's file that holds @p correction.
[[nodiscard]] std::string correctionLine(const ScannerCorrection& correction);

}  // namespace leitstand
