#pragma once

#include <cstdint>

#include "robots/simulation/arena/arena.h"

namespace leitstand::simulation {

/// Generates an arena of @p grade. The same seed gives the same arena on every machine; another seed changes
/// everything. Yellow is a maze on flat floor with ramps of up to 15 degrees. Orange has two levels and
/// stairs with risers of 8 to 10 cm. Red has step fields and rubble. Building is generateBuilding() with its
/// default settings. "kurt3d" and "crawler" start side by side, away from the maze's walls.
[[nodiscard]] Arena generateArena(Grade grade, std::uint64_t seed);

}  // namespace leitstand::simulation
