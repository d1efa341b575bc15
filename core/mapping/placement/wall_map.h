#pragma once

#include <memory>
#include <optional>

#include "core/base/pose.h"
#include "core/cloud/search/search.h"
#include "core/mapping/live/map/local_map.h"

namespace leitstand {

/// The vertical surfaces around a place of the map, seen from above.
struct WallMap {
    PointCloud walls;  ///< in the map's frame with z 0; normals are horizontal and of unit length
    std::unique_ptr<Search> search;  ///< search in `walls`; null when there are none
    double ground = 0.0;             ///< height of the floor around the place [m]
};

/// Returns the walls of @p local around @p place (base_link in the map), from @p low to @p high above the
/// floor there [m]. If the map does not show the floor, base_link is assumed to be on it.
[[nodiscard]] WallMap wallMap(const LocalMap& local, const Pose& place, double low, double high);

}  // namespace leitstand
