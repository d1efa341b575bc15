#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "core/base/result.h"
#include "robots/simulation/arena/arena.h"

namespace leitstand::simulation {

/// Size and features of a generated building.
struct BuildingSettings {
    double width = 60.0;   ///< along x, 28 to 90 [m]
    double depth = 40.0;   ///< along y, 20 to 90 [m]
    int storeys = 1;       ///< 1 to 3, joined by ramps and stairs
    bool twins = false;    ///< all rooms and corridors look alike: places are easily confused
    bool smooth = false;   ///< bare corridors: no rooms, doors, furniture or pillars
    bool troubles = true;  ///< glass and black walls, smoke, people who walk; none when smooth
};

/// Corridors, ramps and rooms of a building, in the arena's frame [m].
struct BuildingWays {
    Eigen::AlignedBox2d ring;  ///< middle line of the ring corridor
    double cross = 0.0;        ///< x of the middle of the corridor that cuts the ring in two
    double storeyHeight = 0.0;
    /// Corners of the way from the ring of each storey up the ramp to the ring of the next.
    std::vector<std::vector<Eigen::Vector3d>> ramps;
    std::vector<Eigen::Vector3d> rooms;  ///< a free place in each room, on its floor
};

struct Building {
    Arena arena;
    BuildingWays ways;
};

/// Generates a building: a ring corridor with a cross corridor, rooms with doors and furniture, a hall, ramps
/// and stairs between storeys. The same settings and seed give the same building on every machine; another
/// seed gives another building. "kurt3d" and "crawler" start side by side in a corner of the ring. Errors
/// name the setting that is out of range.
[[nodiscard]] Result<Building> generateBuilding(const BuildingSettings& settings, std::uint64_t seed);

/// Returns width and depth of "60x40" [m] without checking the building's limits. Error for any other text.
[[nodiscard]] Result<Eigen::Vector2d> buildingSizeFrom(const std::string& text);

}  // namespace leitstand::simulation
