#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/robot/robot_description.h"

namespace leitstand {

class BagReader;

/// Keeps the files of @p robots in the mission's @p folder ("robots/kurt3d.yaml"), so that its log can be
/// read by whoever gets the folder alone.
[[nodiscard]] Result<void> keepRobots(const std::filesystem::path& folder,
                                      const std::vector<RobotDescription>& robots);

/// The robots that a mission's @p folder keeps; a file that cannot be read is told in @p warnings.
[[nodiscard]] std::vector<RobotDescription> keptRobots(const std::filesystem::path& folder,
                                                       std::vector<std::string>& warnings);

/// The robots of @p mission (a folder or a file of one), opened as @p bag: those that its folder keeps, or
/// that the topics of a foreign bag tell of.
[[nodiscard]] std::vector<RobotDescription> robotsOf(const std::filesystem::path& mission,
                                                     const BagReader& bag,
                                                     std::vector<std::string>& warnings);

}  // namespace leitstand
