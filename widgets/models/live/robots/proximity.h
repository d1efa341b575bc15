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
    Unknown,  ///< not seen, or too long ago
    Far,
    Near,     ///< look there
    Touching  ///< act now
};

/// When something is near.
struct ProximityLimits {
    double near = 0.30;      ///< around the standing body [m]
    double touching = 0.12;  ///< [m]
    double ahead = 1.5;      ///< in the direction of motion, Near begins this many seconds farther out [s]
    double maxAge = 12.0;    ///< what was seen longer ago is unknown [s]
};

/// The nearest obstacle in a part of the surroundings.
struct Proximity {
    double from = 0.0, to = 0.0;                                ///< counter-clockwise, base_link [rad]
    double distance = std::numeric_limits<double>::infinity();  ///< from the body's edge [m]
    std::optional<Eigen::Vector2d> where;                       ///< base_link [m]
    Nearness nearness = Nearness::Unknown;
};

/// Returns the distance of @p point from the edge of @p body; 0 within [m].
[[nodiscard]] double distanceFrom(const BodyBox& body, const Eigen::Vector2d& point);

/// Returns eight parts around the robot, the first ahead, then counter-clockwise. @p velocity: as commanded.
[[nodiscard]] std::vector<Proximity> proximityRing(const VirtualScanView& view, const BodyBox& body,
                                                   const DriveVelocity& velocity,
                                                   const ProximityLimits& limits = {});
/// Returns the nearest of @p ring; null when nothing is seen anywhere.
[[nodiscard]] const Proximity* nearestOf(const std::vector<Proximity>& ring);

}  // namespace leitstand
