#pragma once

#include <string>

#include "core/perception/surroundings/virtual_scan_view.h"
#include "core/robot/control/drive_setpoint.h"

namespace leitstand {

/// How careful safe teleoperation is.
struct SafeTeleoperationSettings {
    BodyBox body;               ///< the robot's body [m]
    double margin = 0.05;       ///< distance that is kept free around the body [m]
    double deceleration = 1.0;  ///< braking that the robot certainly achieves [m/s2]
    double delay = 0.25;        ///< time until the robot begins to brake [s]
    double lookAhead = 2.0;     ///< distance that is checked ahead [m]
    double freshAge = 2.6;      ///< sectors up to this age allow full speed: one turn and one slice [s]
    double oldAge = 6.0;        ///< sectors of at least this age, or never seen, only allow creeping [s]
    double creep = 0.10;        ///< creep speed [m/s]
};

/// What remains of the operator's requested velocity.
struct SafeVelocity {
    DriveVelocity velocity;   ///< the requested velocity, slowed down on the same curve
    double share = 1.0;       ///< share of the requested velocity, 0 to 1
    double freeTravel = 0.0;  ///< distance until something is touched, at most lookAhead [m]
    double age = 0.0;         ///< age of the oldest sector into which it drives [s]
    std::string reason;       ///< why it is slowed down, English text; empty: it is not
};

/// Limits @p requested by what the virtual scan saw in the way, and by how long ago it saw it. Keeps the
/// curve. The robot may always creep away from something that it touches.
[[nodiscard]] SafeVelocity safeVelocity(const DriveVelocity& requested, const VirtualScanView& view,
                                        const SafeTeleoperationSettings& settings);

}  // namespace leitstand
