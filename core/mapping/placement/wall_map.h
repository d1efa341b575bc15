#pragma once

#include <memory>
#include <optional>

#include "core/base/pose.h"
#include "core/cloud/search/search.h"
#include "core/mapping/live/map/local_map.h"

namespace leitstand {

/// The upright surfaces around a place of the map, seen from above.
struct WallMap {
    PointCloud walls;                ///< map's frame, z 0; normals level, unit length
    std::unique_ptr<Search> search;  ///< over the walls; null when there are none
    double ground = 0.0;             ///< height of the floor around the place [m]
};

/// Returns the walls of @p local around @p place (base_link in the map), from @p low to @p high over the
/// floor there [m]. If the map does not show the floor, base_link is taken to stand on it.
[[nodiscard]] WallMap wallMap(const LocalMap& local, const Pose& place, double low, double high);

}  // namespace leitstand
