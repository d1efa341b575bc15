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
    double width = 60.0;  ///< extent along x, 28 to 90 [m]
    double depth = 40.0;  ///< extent along y, 20 to 90 [m]
    int storeys = 1;      ///< 1 to 3, connected by ramps and stairs
    bool twins = false;   ///< whether all rooms and corridors look alike, so that places are easily confused
    bool smooth = false;  ///< whether corridors are bare: no rooms, doors, furniture or pillars
    /// Whether there are glass and black walls, smoke, and people who walk; never if `smooth`.
    bool troubles = true;
};

/// Corridors, ramps and rooms of a building, in the arena's frame [m].
struct BuildingWays {
    Eigen::AlignedBox2d ring;  ///< middle of the ring corridor, as a rectangle
    double cross = 0.0;        ///< x of the middle of the corridor that crosses the ring
    double storeyHeight = 0.0;
    /// Corners of the way from the ring of each storey, up the ramp, to the ring of the next storey.
    std::vector<std::vector<Eigen::Vector3d>> ramps;
    std::vector<Eigen::Vector3d> rooms;  ///< a free place in each room, on its floor
};

struct Building {
    Arena arena;
    BuildingWays ways;
};

/// Generates a building: a ring corridor with a cross corridor, rooms with doors and furniture, a hall, and
/// ramps and stairs between storeys. The same settings and seed give the same building on every machine;
/// another seed gives another building. "kurt3d" and "crawler" start side by side in a corner of the ring.
/// Errors name the setting that is out of range.
[[nodiscard]] Result<Building> generateBuilding(const BuildingSettings& settings, std::uint64_t seed);

/// Parses width and depth [m] from a text such as "60x40". Does not check the limits of buildings. Error for
/// any other text.
[[nodiscard]] Result<Eigen::Vector2d> buildingSizeFrom(const std::string& text);

}  // namespace leitstand::simulation
