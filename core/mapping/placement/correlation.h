#pragma once

#include "core/mapping/placement/laser_view.h"
#include "core/mapping/placement/wall_map.h"
#include "core/mapping/walls/flat_pose.h"

namespace leitstand {

/// Poses around a guess at which a robot is looked for.
struct SearchWindow {
    double distance = 0.8;       ///< to either side, along x and along y [m]
    double angle = degrees(30);  ///< to either side [rad]
};

/// The best fit of a laser's view within a window.
struct Correlation {
    FlatPose pose;
    double score = 0.0;  ///< mean likelihood of its points, 0 to 1
    /// Best score of another place (see Apart, TurnedApart); at least ClearBelow times `score`.
    double second = 0.0;
    static constexpr double Apart = 0.35;               ///< another place is at least this far away [m] ...
    static constexpr double TurnedApart = degrees(20);  ///< ... or turned by this [rad]
    static constexpr double ClearBelow = 0.6;
};

/// Compares @p view with @p map at all poses of @p window around @p guess, in steps of 5 cm and 1 degree.
/// First computes bounds of the scores for blocks of poses, then scores the poses in the best blocks (Olson
/// 2009).
[[nodiscard]] Correlation correlate(const LaserView& view, const WallMap& map, const FlatPose& guess,
                                    const SearchWindow& window);

}  // namespace leitstand
