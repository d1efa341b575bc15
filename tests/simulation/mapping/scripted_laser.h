#pragma once

#include <vector>

#include "core/event/cloud_sample.h"
#include "robots/simulation/sensors/laser/plane_laser.h"
#include "tests/simulation/mapping/scripted_motion.h"

namespace leitstand::simulation::test {

/// Turns of a plane laser on a scripted motion: what a robot of the simulation with @p laser, mounted as its
/// settings say, would publish. Each shot is cast from where the laser is at that instant.
[[nodiscard]] std::vector<RangesSample> scriptedTurns(const Arena& arena, const ScriptedMotion& motion,
                                                      const PlaneLaserSettings& laser, std::uint64_t seed);

}  // namespace leitstand::simulation::test
