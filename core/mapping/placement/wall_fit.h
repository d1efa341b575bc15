#pragma once

#include <vector>

#include "core/mapping/placement/laser_view.h"
#include "core/mapping/placement/wall_map.h"
#include "core/mapping/walls/flat_pose.h"

namespace leitstand {

/// How a laser's view fits walls.
struct WallFit {
    FlatPose pose;
    double overlap = 0.0;    ///< share of its points that are within OverlapDistance of a wall
    double rms = 0.0;        ///< root mean square distance of these points, across the walls [m]
    double direction = 0.0;  ///< how well the walls determine the worst direction, 0 to 1
    static constexpr double OverlapDistance = 0.10;  ///< largest distance of a point that lies on a wall [m]
    static constexpr double OpenBelow = 0.02;  ///< least `direction` for moving the view in all directions
};

/// Moves @p view onto the walls of @p map, point to line (Censi 2008), starting at @p guess. @p distances:
/// largest distance of a pair in each stage [m]. The view is not moved in directions that the walls do not
/// determine.
[[nodiscard]] WallFit fitToWalls(const LaserView& view, const WallMap& map, const FlatPose& guess,
                                 const std::vector<double>& distances);

}  // namespace leitstand
