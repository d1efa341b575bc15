#pragma once

#include <vector>

#include "core/mapping/placement/laser_view.h"
#include "core/mapping/placement/wall_map.h"
#include "core/mapping/walls/flat_pose.h"

namespace leitstand {

/// A laser's view, fitted to walls.
struct WallFit {
    FlatPose pose;
    double overlap = 0.0;    ///< share of its points within OverlapDistance of a wall
    double rms = 0.0;        ///< root mean square distance of these points, across the walls [m]
    double direction = 0.0;  ///< 0 to 1: how well the walls hold the direction that they hold worst
    static constexpr double OverlapDistance = 0.10;  ///< [m]
    static constexpr double OpenBelow = 0.02;        ///< least `direction` in which the view is moved
};

/// Moves @p view onto the walls of @p map, point to line (Censi 2008), starting at @p guess. @p distances:
/// largest distance of pairs, stage by stage [m]. The view is not moved in directions that the walls leave
/// open.
[[nodiscard]] WallFit fitToWalls(const LaserView& view, const WallMap& map, const FlatPose& guess,
                                 const std::vector<double>& distances);

}  // namespace leitstand
