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

/// Distances and ages by which Nearness is judged.
struct ProximityLimits {
    double near = 0.30;      ///< Near up to this distance from a standing body [m]
    double touching = 0.12;  ///< Touching up to this distance [m]
    double ahead = 1.5;      ///< Near reaches farther by the approach speed times this [s]
    double maxAge = 12.0;    ///< what was seen longer ago is unknown [s]
};

/// The nearest obstacle in a part of the surroundings.
struct Proximity {
    double from = 0.0, to = 0.0;                                ///< counter-clockwise, base_link [rad]
    double distance = std::numeric_limits<double>::infinity();  ///< from the body's edge [m]
    std::optional<Eigen::Vector2d> where;  ///< of the obstacle, base_link [m]; empty: none
    Nearness nearness = Nearness::Unknown;
};

/// Returns the distance of @p point from the edge of @p body [m]; 0 within the body.
[[nodiscard]] double distanceFrom(const BodyBox& body, const Eigen::Vector2d& point);

/// Returns eight parts around the robot, the first ahead, then counter-clockwise. @p velocity: as commanded.
[[nodiscard]] std::vector<Proximity> proximityRing(const VirtualScanView& view, const BodyBox& body,
                                                   const DriveVelocity& velocity,
                                                   const ProximityLimits& limits = {});
/// Returns the nearest of @p ring; null when nothing is seen anywhere.
[[nodiscard]] const Proximity* nearestOf(const std::vector<Proximity>& ring);

}  // namespace leitstand
