#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/perception/surroundings/virtual_scan_view.h"
#include "core/robot/control/drive_setpoint.h"

namespace leitstand {

/// How near something is.
enum class Nearness {
    Unknown,  ///< not seen, or seen too long ago
    Far,
    Near,     ///< the operator should look there
    Touching  ///< the operator must act now
};

/// Distances and ages that determine Nearness.
struct ProximityLimits {
    double near = 0.30;      ///< Near up to this distance from a standing body [m]
    double touching = 0.12;  ///< Touching up to this distance [m]
    /// Time by which the approach speed is multiplied and added to the distance for Near [s].
    double ahead = 1.5;
    double maxAge = 12.0;  ///< what was seen longer ago than this is unknown [s]
};

/// The nearest obstacle in a part of the surroundings.
struct Proximity {
    double from = 0.0, to = 0.0;  ///< directions counter-clockwise, in base_link [rad]
    double distance = std::numeric_limits<double>::infinity();  ///< distance from the body's edge [m]
    std::optional<Eigen::Vector2d> where;  ///< the obstacle in base_link [m]; empty: none
    Nearness nearness = Nearness::Unknown;
};

/// Returns the distance of @p point from the edge of @p body [m]; 0 within the body.
[[nodiscard]] double distanceFrom(const BodyBox& body, const Eigen::Vector2d& point);

/// Returns eight parts around the robot: the first is ahead, the others follow counter-clockwise.
/// @p velocity: commanded velocity.
[[nodiscard]] std::vector<Proximity> proximityRing(const VirtualScanView& view, const BodyBox& body,
                                                   const DriveVelocity& velocity,
                                                   const ProximityLimits& limits = {});
/// Returns the nearest part of @p ring; null when nothing is seen in any.
[[nodiscard]] const Proximity* nearestOf(const std::vector<Proximity>& ring);

}  // namespace leitstand
