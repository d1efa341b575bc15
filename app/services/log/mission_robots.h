#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/robot/robot_description.h"

namespace leitstand {

class BagReader;

/// Stores the files of @p robots in the mission's @p folder ("robots/kurt3d.yaml"), so that only the folder
/// is needed to read its log.
[[nodiscard]] Result<void> keepRobots(const std::filesystem::path& folder,
                                      const std::vector<RobotDescription>& robots);

/// Returns the robots that are kept in a mission's @p folder. Adds the files that cannot be read to
/// @p warnings.
[[nodiscard]] std::vector<RobotDescription> keptRobots(const std::filesystem::path& folder,
                                                       std::vector<std::string>& warnings);

/// Returns the robots whose files are kept in the folder of @p mission (that folder, or a file in it). If
/// there are none, guesses robots from the topics of @p bag, which is the opened mission.
[[nodiscard]] std::vector<RobotDescription> robotsOf(const std::filesystem::path& mission,
                                                     const BagReader& bag,
                                                     std::vector<std::string>& warnings);
/// Sets for each of @p robots which of several clouds makes the map, as it was last chosen in the mission in
/// @p folder. If the mission has no choice, or the robot no longer has these clouds, the robot's own file
/// decides.
void carryMapping(const std::filesystem::path& folder, std::vector<RobotDescription>& robots);

}  // namespace leitstand
