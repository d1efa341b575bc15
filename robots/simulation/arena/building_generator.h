#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "core/base/result.h"
#include "robots/simulation/arena/arena.h"

namespace leitstand::simulation {

/// What a generated building is like.
struct BuildingSettings {
    double width = 60.0;   ///< along x [m]
    double depth = 40.0;   ///< along y [m]
    int storeys = 1;       ///< joined by ramps and stairs
    bool twins = false;    ///< all rooms and corridors alike: places that are taken for others
    bool smooth = false;   ///< bare corridors: no rooms, doors, furniture or pillars
    bool troubles = true;  ///< glass and black walls, smoke, people who walk; not where it is smooth
};

/// Where one gets about in a building, arena's frame [m].
struct BuildingWays {
    Eigen::AlignedBox2d ring;  ///< middle of the ring corridor
    double cross = 0.0;        ///< x of the middle of the corridor that cuts the ring in two
    double storeyHeight = 0.0;
    /// From the ring of each storey up the ramp to the ring of the next: corners of the way.
    std::vector<std::vector<Eigen::Vector3d>> ramps;
    std::vector<Eigen::Vector3d> rooms;  ///< a free place in each, on its floor
};

struct Building {
    Arena arena;
    BuildingWays ways;
};

/// A building: a ring corridor with a cross corridor, rooms with doors and furniture, a hall, ramps and
/// stairs between storeys. The same for the same settings and seed on every machine; another seed is another
/// building. "kurt3d" and "crawler" start side by side in a corner of the ring. Errors name what is out of
/// range.
[[nodiscard]] Result<Building> generateBuilding(const BuildingSettings& settings, std::uint64_t seed);

/// Width and depth of "60x40" [m]; the building's limits are not looked at here.
[[nodiscard]] Result<Eigen::Vector2d> buildingSizeFrom(const std::string& text);

}  // namespace leitstand::simulation
