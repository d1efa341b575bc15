#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace leitstand {

/// What floor and obstacles are to a robot; for a known robot, see profileOf().
struct ProfileSettings {
    double climb = 0.3665;      ///< steepest ramp that it climbs [rad] (21 degrees)
    double step = 0.05;         ///< highest step that it takes; lower obstacles are not seen [m]
    double height = 0.75;       ///< of the robot: what is higher over the floor does not stop it [m]
    double drop = 0.12;         ///< deepest step down that it takes; deeper ones are obstacles [m]
    double wallHeight = 2.2;    ///< points higher over the robot's ground are no walls [m]
    double support = 0.10;      ///< an obstacle's points have another one within this distance ... [m]
    double supportRate = 0.05;  ///< ... plus this share of their range; others count as mixed pixels
};

/// A point of a vertical raw scan, seen from above its ground.
struct ProfilePoint {
    double distance = 0.0;                            ///< horizontally from the scanner [m]
    double height = 0.0;                              ///< over the ground that the robot stands on [m]
    Eigen::Vector2d where = Eigen::Vector2d::Zero();  ///< horizontal position, frame of the caller [m]
};

/// Result of a vertical raw scan for a driver.
struct ProfileContour {
    std::optional<ProfilePoint> outer;  ///< the farthest point below wallHeight: walls
    std::optional<ProfilePoint> inner;  ///< the nearest that is neither floor nor ceiling: obstacles
    double innerTop = 0.0;     ///< height of its upper end over the floor before it; as far as seen [m]
    double innerBottom = 0.0;  ///< ... and of its lower end: a shelf's is as high as the shelf [m]
};

/// Finds the contours in one vertical raw scan (paper, section 2.3). @p points by rising elevation;
/// @p neighbour: the raw scan beside it, for support, may be empty.
///
/// Floor is what is reached from the robot's own ground without a slope above the climbing angle or a step
/// higher or deeper than it takes. So ramps are floor. Kerbs, table edges, half-open shutters, curtains and
/// stairs, up or down, are not. What leaves the robot's height free above the floor is ceiling.
[[nodiscard]] ProfileContour contourOf(std::span<const ProfilePoint> points,
                                       std::span<const ProfilePoint> neighbour,
                                       const ProfileSettings& settings);

}  // namespace leitstand
