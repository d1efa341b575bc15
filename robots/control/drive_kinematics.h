#pragma once

#include "core/robot/control/drive_setpoint.h"

namespace leitstand {

/// Geometry and speed limit of a skid-steered drive.
struct DriveGeometry {
    double trackWidth = 0.4;  ///< between the middles of the sides; larger for drives that slip in turns [m]
    double maxSpeed = 0.6;    ///< of a side [m/s]
};

/// Speeds of the two sides [m/s].
struct SideSpeeds {
    double left = 0.0, right = 0.0;
};

/// Returns the sides' speeds for @p velocity. When a side would be too fast, both are scaled, so that the
/// robot drives the same curve more slowly. Zero when a number is not finite; sideways motion is ignored.
[[nodiscard]] SideSpeeds sidesFor(const DriveVelocity& velocity, const DriveGeometry& geometry);
/// Returns how the robot moves with these side speeds, without slip.
[[nodiscard]] DriveVelocity velocityOf(const SideSpeeds& sides, const DriveGeometry& geometry);

}  // namespace leitstand
