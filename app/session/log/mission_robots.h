#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Keeps the files of @p robots in the mission's @p folder ("robots/kurt3d.yaml"), so that its log can be
/// read by whoever gets the folder alone.
[[nodiscard]] Result<void> keepRobots(const std::filesystem::path& folder,
                                      const std::vector<RobotDescription>& robots);

/// The robots that a mission's @p folder keeps; a file that cannot be read is told in @p warnings.
[[nodiscard]] std::vector<RobotDescription> keptRobots(const std::filesystem::path& folder,
                                                       std::vector<std::string>& warnings);

}  // namespace leitstand
