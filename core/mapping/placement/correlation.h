#pragma once

#include "core/mapping/placement/laser_view.h"
#include "core/mapping/placement/wall_map.h"
#include "core/mapping/walls/flat_pose.h"

namespace leitstand {

/// The window around a guess in which a robot is looked for.
struct SearchWindow {
    double distance = 0.8;       ///< along x and along y, to either side [m]
    double angle = degrees(30);  ///< to either side [rad]
};

/// The best fit of a laser's view within a window.
struct Correlation {
    FlatPose pose;
    double score = 0.0;   ///< 0 to 1: mean likelihood of its points
    double second = 0.0;  ///< best score of another place (farther away than Apart or TurnedApart); at least
                          ///< ClearBelow times `score`
    static constexpr double Apart = 0.35;               ///< [m] ...
    static constexpr double TurnedApart = degrees(20);  ///< ... or [rad]
    static constexpr double ClearBelow = 0.6;
};

/// Compares @p view with @p map at all poses of @p window around @p guess, in steps of 5 cm and 1 degree. It
/// bounds the scores of blocks of poses first, then scores the poses of the best blocks (Olson 2009).
[[nodiscard]] Correlation correlate(const LaserView& view, const WallMap& map, const FlatPose& guess,
                                    const SearchWindow& window);

}  // namespace leitstand
