#pragma once

#include <cstdint>
#include <vector>

#include "core/mapping/comparison/map_changes.h"
#include "robots/simulation/arena/building_generator.h"
#include "tests/simulation/mapping/scripted_drive.h"

namespace leitstand::simulation::test {

/// The same stretch of a building, driven on one day and, the other way, a day later; boxes came and went in
/// between. Scanners are as real ones are.
struct TwoDays {
    std::vector<Element> came, went;  ///< frames of the arena
    ScriptedDrive first, second;      ///< both of "kurt3d"

    /// Where its base is in the arena at the end of @p scan of either drive.
    [[nodiscard]] Pose baseInArena(const Scan& scan) const;
};

/// In the building of 30 x 20 m of @p seed, with all its troubles.
[[nodiscard]] TwoDays twoDays(std::uint64_t seed);

/// How what was told of changes compares with what changed.
struct ToldChanges {
    int right = 0, missed = 0, wrong = 0;
};

/// @p arenaInMap: of the map that @p things are in. Prints what is wrong.
[[nodiscard]] ToldChanges judged(const std::vector<ChangedThing>& things, const TwoDays& days,
                                 const Pose& arenaInMap);

}  // namespace leitstand::simulation::test
