#pragma once

#include "core/mapping/live/map/local_map.h"
#include "core/mapping/placement/laser_view.h"
#include "core/mapping/placement/wall_map.h"
#include "core/mapping/walls/flat_pose.h"

namespace leitstand {

/// Returns the share of @p view's points that contradict a laser at @p pose. These points lie behind the
/// walls of @p map, or where @p local has open floor. @p map: wallMap() of @p local. The share is about zero
/// at the robot's true pose, whatever the map lacks so far. It is large where the place only looks alike.
[[nodiscard]] double contradiction(const LaserView& view, const LocalMap& local, const WallMap& map,
                                   const FlatPose& pose);

}  // namespace leitstand
