#pragma once

#include "core/robot/control/drive_setpoint.h"

namespace leitstand {

/// Geometry and speed limit of a skid-steered drive.
struct DriveGeometry {
    /// Distance between the middles of the sides [m]; larger for drives that slip in turns.
    double trackWidth = 0.4;
    double maxSpeed = 0.6;  ///< largest speed of a side [m/s]
};

/// Speeds of the two sides [m/s].
struct SideSpeeds {
    double left = 0.0, right = 0.0;
};

/// Returns the speeds of the sides for @p velocity. If one side would be too fast, both are scaled, so that
/// the robot drives the same curve more slowly. Zero when a number is not finite. Ignores sideways motion.
[[nodiscard]] SideSpeeds sidesFor(const DriveVelocity& velocity, const DriveGeometry& geometry);
/// Returns how the robot moves at these speeds of the sides, without slip.
[[nodiscard]] DriveVelocity velocityOf(const SideSpeeds& sides, const DriveGeometry& geometry);

}  // namespace leitstand
