#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace leitstand {

/// What floor and obstacles are to a robot; for a known robot, see profileOf().
struct ProfileSettings {
    double climb = 0.3665;      ///< steepest ramp that it climbs [rad] (21 degrees)
    double step = 0.05;         ///< highest step that it takes [m]; lower obstacles are not reported
    double height = 0.75;       ///< of the robot [m]; what is higher over the floor does not stop it
    double drop = 0.12;         ///< deepest step down that it takes [m]; a deeper one is an obstacle
    double wallHeight = 2.2;    ///< points higher over the robot's ground are no walls [m]
    double support = 0.10;      ///< a point of an obstacle has another point within this distance ... [m]
    double supportRate = 0.05;  ///< ... plus this share of its range; other points count as mixed pixels
};

/// A point of a vertical raw scan, as distance and height.
struct ProfilePoint {
    double distance = 0.0;                            ///< horizontally from the scanner [m]
    double height = 0.0;                              ///< over the ground that the robot stands on [m]
    Eigen::Vector2d where = Eigen::Vector2d::Zero();  ///< horizontal position, frame of the caller [m]
};

/// What a driver needs of a vertical raw scan.
struct ProfileContour {
    std::optional<ProfilePoint> outer;  ///< the farthest point below wallHeight, usually a wall
    std::optional<ProfilePoint> inner;  ///< the nearest point that is neither floor nor ceiling: an obstacle
    /// Height of the obstacle's upper end over the floor before it, as far as seen [m].
    double innerTop = 0.0;
    /// Height of the obstacle's lower end over that floor [m]: for a shelf, the height of its board.
    double innerBottom = 0.0;
};

/// Finds the contours in one vertical raw scan (paper, section 2.3). @p points: by rising elevation.
/// @p neighbour: the raw scan beside it, whose points may support those of an obstacle; may be empty.
///
/// Floor is all that is reached from the robot's own ground without a slope above the climbing angle, or a
/// step higher or deeper than the robot takes. So ramps are floor. Kerbs, table edges, half-open shutters,
/// curtains and stairs, up or down, are not. What hangs higher above the floor than the robot's height is
/// ceiling.
[[nodiscard]] ProfileContour contourOf(std::span<const ProfilePoint> points,
                                       std::span<const ProfilePoint> neighbour,
                                       const ProfileSettings& settings);

}  // namespace leitstand
