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

/// The robot's file @p text, named @p name in errors, with @p correction for its sensor @p sensor; all else,
/// comments too, stays as it was written. Errors, in words: there is no such sensor, or it is written in a
/// way that is not known here, so that the correction has to be written by hand.
[[nodiscard]] Result<std::string> withCorrection(const std::string& text, const std::string& name,
                                                 const std::string& sensor,
                                                 const ScannerCorrection& correction);
/// The line of a robot's file that says @p correction.
[[nodiscard]] std::string correctionLine(const ScannerCorrection& correction);

}  // namespace leitstand
