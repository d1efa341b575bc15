#pragma once

#include <span>

#include "core/base/result.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Checks that @p robots can work side by side: names and letters differ, and no two share a topic. They may
/// share /tf where both put their name before their frames, and /diagnostics where their hardware_id differs.
/// The error names the robots and the topic, a line for each clash.
[[nodiscard]] Result<void> checkTeam(std::span<const RobotDescription> robots);

}  // namespace leitstand
