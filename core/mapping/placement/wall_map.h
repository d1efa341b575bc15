#pragma once

#include <memory>
#include <optional>

#include "core/base/pose.h"
#include "core/cloud/search/search.h"
#include "core/mapping/live/map/local_map.h"

namespace leitstand {

/// What stands up about a place of the map, seen from above.
struct WallMap {
    PointCloud walls;                ///< map's frame, z 0; normals level, unit length
    std::unique_ptr<Search> search;  ///< over the walls; null when there are none
    double ground = 0.0;             ///< height of the floor about the place [m]
};

/// The walls of @p local about @p place (base_link in the map), between @p low and @p high over the floor
/// there [m]; where the map does not show the floor, base_link stands on it.
[[nodiscard]] WallMap wallMap(const LocalMap& local, const Pose& place, double low, double high);

}  // namespace leitstand
