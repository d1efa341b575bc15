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
    double rms = 0.0;        ///< of those, across the walls [m]
    double direction = 0.0;  ///< 0 to 1: how well the walls hold the direction that they hold worst
    static constexpr double OverlapDistance = 0.10;  ///< [m]
    static constexpr double OpenBelow = 0.02;        ///< of direction; below, the view was not moved that way
};

/// Moves @p view onto the walls of @p map, point to line (Censi 2008), starting at @p guess. @p distances:
/// pairs farther apart are dropped, stage by stage [m]. It is not moved in directions that the walls leave
/// open.
[[nodiscard]] WallFit fitToWalls(const LaserView& view, const WallMap& map, const FlatPose& guess,
                                 const std::vector<double>& distances);

}  // namespace leitstand
