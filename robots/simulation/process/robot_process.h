#pragma once

#include "core/base/result.h"
#include "robots/simulation/process/robot_options.h"

namespace leitstand::simulation {

/// Lives as a robot in real time until SIGINT or SIGTERM. Says "NAME is in ARENA on domain N" on stdout when
/// it is there.
[[nodiscard]] Result<void> runRobot(const RobotOptions& options);

}  // namespace leitstand::simulation
