#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/robot/robot_description.h"

namespace leitstand {

class BagReader;

/// Stores the files of @p robots in the mission's @p folder ("robots/kurt3d.yaml"), so that its log can be
/// read with the folder alone.
[[nodiscard]] Result<void> keepRobots(const std::filesystem::path& folder,
                                      const std::vector<RobotDescription>& robots);

/// Returns the robots that a mission's @p folder keeps; adds to @p warnings the files that cannot be read.
[[nodiscard]] std::vector<RobotDescription> keptRobots(const std::filesystem::path& folder,
                                                       std::vector<std::string>& warnings);

/// Returns the robots that the folder of @p mission keeps (a folder or a file of one, opened as @p bag).
/// Without any, guesses them from the topics of a foreign bag.
[[nodiscard]] std::vector<RobotDescription> robotsOf(const std::filesystem::path& mission,
                                                     const BagReader& bag,
                                                     std::vector<std::string>& warnings);

}  // namespace leitstand
