#pragma once

#include <span>

#include "core/base/result.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Checks that @p robots can work side by side: no two have the same name, letter or topic. They may share
/// /tf if both put their names before their frames, and /diagnostics if their hardware_id differs. The error
/// has a line for each conflict, with the robots and the topic.
[[nodiscard]] Result<void> checkTeam(std::span<const RobotDescription> robots);

}  // namespace leitstand
