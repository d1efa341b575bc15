#pragma once

#include "core/base/result.h"
#include "robots/simulation/process/robot_options.h"

namespace leitstand::simulation {

/// Runs a robot in real time until SIGINT or SIGTERM. Prints "NAME is in ARENA on domain N" on stdout when it
/// is ready.
[[nodiscard]] Result<void> runRobot(const RobotOptions& options);

}  // namespace leitstand::simulation
