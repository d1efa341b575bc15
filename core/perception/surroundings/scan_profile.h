#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace leitstand {

/// What counts as floor and as an obstacle for a robot. For a known robot use profileOf().
struct ProfileSettings {
    double climb = 0.3665;  ///< steepest ramp that it climbs [rad] (21 degrees)
    double step = 0.05;     ///< highest step up that it takes [m]; lower obstacles are not reported
    /// Height of the robot [m]; things higher than this above the floor do not stop it.
    double height = 0.75;
    double drop = 0.12;       ///< deepest step down that it takes [m]; a deeper one is an obstacle
    double wallHeight = 2.2;  ///< points higher than this above the robot's ground are not used as walls [m]
    double support = 0.10;    ///< a point of an obstacle has another point within this distance ... [m]
    /// ... plus this share of its range; a point without such a neighbour is a mixed pixel.
    double supportRate = 0.05;
};

/// A point of a vertical raw scan, as distance and height.
struct ProfilePoint {
    double distance = 0.0;  ///< horizontal distance from the scanner [m]
    double height = 0.0;    ///< height above the ground that the robot stands on [m]
    /// Horizontal position, in a frame that the caller chooses [m].
    Eigen::Vector2d where = Eigen::Vector2d::Zero();
};

/// What a vertical raw scan shows that matters for driving.
struct ProfileContour {
    std::optional<ProfilePoint> outer;  ///< the farthest point below wallHeight, usually a wall
    std::optional<ProfilePoint> inner;  ///< the nearest point that is neither floor nor ceiling: an obstacle
    /// Height of the obstacle's upper end above the floor in front of it, as far as it was seen [m].
    double innerTop = 0.0;
    /// Height of the obstacle's lower end above that floor [m]; for a shelf, the height of its board.
    double innerBottom = 0.0;
};

/// Finds the contours in one vertical raw scan (paper, section 2.3). @p points: by rising elevation.
/// @p neighbour: the raw scan beside it, whose points may support points of an obstacle; may be empty.
///
/// Floor is everything that can be reached from the robot's own ground without too steep a slope, or too high
/// or too deep a step. So ramps are floor. Kerbs, table edges, half-open shutters, curtains and stairs (up or
/// down) are obstacles. Things that hang higher above the floor than the robot's height are ceiling.
[[nodiscard]] ProfileContour contourOf(std::span<const ProfilePoint> points,
                                       std::span<const ProfilePoint> neighbour,
                                       const ProfileSettings& settings);

}  // namespace leitstand
