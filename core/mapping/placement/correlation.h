#pragma once

#include "core/mapping/placement/laser_view.h"
#include "core/mapping/placement/wall_map.h"
#include "core/mapping/walls/flat_pose.h"

namespace leitstand {

/// How far about a guess a robot is looked for.
struct SearchWindow {
    double distance = 0.8;       ///< along x and along y, either way [m]
    double angle = degrees(30);  ///< either way [rad]
};

/// Where a laser's view fits best within a window.
struct Correlation {
    FlatPose pose;
    double score = 0.0;   ///< 0 to 1: mean likelihood of its points
    double second = 0.0;  ///< the best score more than Apart away; at least ToldFrom of the score
    static constexpr double Apart = 0.35;               ///< [m] ...
    static constexpr double TurnedApart = degrees(20);  ///< ... or [rad]
    static constexpr double ToldFrom = 0.6;
};

/// Compares @p view with @p map at all poses of @p window about @p guess, in steps of 5 cm and 1 degree:
/// first blocks of poses by what none of theirs can exceed, then the poses of the best blocks (Olson 2009).
[[nodiscard]] Correlation correlate(const LaserView& view, const WallMap& map, const FlatPose& guess,
                                    const SearchWindow& window);

}  // namespace leitstand
