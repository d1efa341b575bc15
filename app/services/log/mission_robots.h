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

/// Returns the robots whose files are kept in the folder of @p mission (that folder, or a file in it). If
/// there are none, guesses robots from the topics of @p bag, the opened mission.
[[nodiscard]] std::vector<RobotDescription> robotsOf(const std::filesystem::path& mission,
                                                     const BagReader& bag,
                                                     std::vector<std::string>& warnings);
/// Sets in each of @p robots which of several clouds makes the map, as the mission in @p folder chose last.
/// The robot's own file counts where the mission has no choice, or the robot no such clouds any more.
void carryMapping(const std::filesystem::path& folder, std::vector<RobotDescription>& robots);

}  // namespace leitstand
