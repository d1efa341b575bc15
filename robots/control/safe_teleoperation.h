#pragma once

#include <string>

#include "core/perception/surroundings/virtual_scan_view.h"
#include "core/robot/control/drive_setpoint.h"

namespace leitstand {

/// How careful safe teleoperation is.
struct SafeTeleoperationSettings {
    BodyBox body;               ///< of the robot [m]
    double margin = 0.05;       ///< distance that stays free around the body [m]
    double deceleration = 1.0;  ///< braking that the robot can count on [m/s2]
    double delay = 0.25;        ///< until the robot begins to brake [s]
    double lookAhead = 2.0;     ///< [m]
    double freshAge = 2.6;      ///< sectors up to this age allow full speed: a turn and a slice [s]
    double oldAge = 6.0;        ///< sectors of at least this age, or never seen, allow creep only [s]
    double creep = 0.10;        ///< [m/s]
};

/// What is left of the operator's wish.
struct SafeVelocity {
    DriveVelocity velocity;   ///< the wish, slowed down on the same curve
    double share = 1.0;       ///< of the wish, 0 to 1
    double freeTravel = 0.0;  ///< until something would be touched, at most lookAhead [m]
    double age = 0.0;         ///< of the oldest sector that it drives into [s]
    std::string reason;       ///< why it is slowed down, in words; empty: it is not
};

/// Limits @p requested by what the virtual scan saw in the way and by how long ago that was. Keeps the curve;
/// the robot may always creep away from what it touches.
[[nodiscard]] SafeVelocity safeVelocity(const DriveVelocity& requested, const VirtualScanView& view,
                                        const SafeTeleoperationSettings& settings);

}  // namespace leitstand
