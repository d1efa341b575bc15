#pragma once

#include "core/mapping/live/map/local_map.h"
#include "core/mapping/placement/laser_view.h"
#include "core/mapping/placement/wall_map.h"
#include "core/mapping/walls/flat_pose.h"

namespace leitstand {

/// Share of @p view's points that speak against a laser at @p pose: it would see them through the walls of
/// @p map, which are of @p local, or where @p local has open floor. About none where the robot truly stands,
/// whatever the map does not have yet; many where it only looks alike.
[[nodiscard]] double contradiction(const LaserView& view, const LocalMap& local, const WallMap& map,
                                   const FlatPose& pose);

}  // namespace leitstand
