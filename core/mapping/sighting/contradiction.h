#pragma once

#include "core/mapping/live/map/local_map.h"
#include "core/mapping/placement/laser_view.h"
#include "core/mapping/placement/wall_map.h"
#include "core/mapping/walls/flat_pose.h"

namespace leitstand {

/// Returns the share of points of @p view that contradict a laser at @p pose: they lie behind the walls of
/// @p map, or where @p local has open floor. @p map: wallMap() of @p local. At the robot's true pose the
/// share is about zero, even if the map is incomplete. It is large at a place that only looks similar.
[[nodiscard]] double contradiction(const LaserView& view, const LocalMap& local, const WallMap& map,
                                   const FlatPose& pose);

}  // namespace leitstand
