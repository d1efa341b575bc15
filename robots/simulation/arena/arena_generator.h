#pragma once

#include <cstdint>

#include "robots/simulation/arena/arena.h"

namespace leitstand::simulation {

/// An arena of @p grade, the same for the same seed on every machine; another seed rearranges everything.
/// Yellow: a maze on flat floor with ramps to 15 degrees; orange: stairs with risers of 8 to 10 cm, two
/// levels; red: step fields and rubble; building: generateBuilding() as usual. "kurt3d" and "crawler" start
/// side by side, outside the maze's walls' reach.
[[nodiscard]] Arena generateArena(Grade grade, std::uint64_t seed);

}  // namespace leitstand::simulation
