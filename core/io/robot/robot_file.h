#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Largest robot file that is read [bytes].
constexpr std::size_t MaxRobotFileSize = 256 * 1024;

/// The description in a robot file (YAML; docs/robots.md lists the keys and their defaults).
///
/// What is wrong is told in one text, a line for each error, in the order of the file: file, line, key,
/// what was expected and what stands there ("kurt3d.yaml:14: streams[3].qos.reliability: expected best_effort
/// or reliable, found \"maybe\"").
[[nodiscard]] Result<RobotDescription> readRobot(const std::filesystem::path& file);

/// The same for a text; @p name stands for the file in errors.
[[nodiscard]] Result<RobotDescription> parseRobot(std::string_view text, const std::string& name);

/// A robot file, commented for people, from which parseRobot() reads an equal description.
[[nodiscard]] std::string writeRobot(const RobotDescription& robot);

}  // namespace leitstand
