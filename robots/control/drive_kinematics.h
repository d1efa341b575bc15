#pragma once

#include "core/robot/control/drive_setpoint.h"

namespace leitstand {

/// How the sides of a skid-steered robot make it move.
struct DriveGeometry {
    double trackWidth = 0.4;  ///< between the middles of the sides; larger for drives that slip in turns [m]
    double maxSpeed = 0.6;    ///< of a side [m/s]
};

/// Speeds of the two sides [m/s].
struct SideSpeeds {
    double left = 0.0, right = 0.0;
};

/// The sides' speeds for @p velocity. Where a side would be too fast, both are scaled, so that the robot
/// drives the same curve more slowly. Zero when a number is none; sideways is not possible and left out.
[[nodiscard]] SideSpeeds sidesFor(const DriveVelocity& velocity, const DriveGeometry& geometry);
/// How the robot moves when its sides do, without slip.
[[nodiscard]] DriveVelocity velocityOf(const SideSpeeds& sides, const DriveGeometry& geometry);

}  // namespace leitstand
