#pragma once

#include <chrono>
#include <string>

#include "core/base/result.h"
#include "core/event/raw_event.h"
#include "core/robot/control/drive_setpoint.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// How a robot is commanded: a Twist or TwistStamped, or speeds of its tracks [m/s] in a JointState.
struct DriveMessage {
    StreamDescription stream;    ///< drive_command or track_command
    std::string frame;           ///< frame of commands with a stamp
    double trackDistance = 0.0;  ///< distance between the tracks, for track commands [m]
    /// Names of the joints in track commands.
    std::string leftTrack = "left_track", rightTrack = "right_track";

    /// Encodes the command for @p velocity with the present time as stamp. @p clockAhead: robot's clock minus
    /// this computer's clock.
    [[nodiscard]] Result<Payload> encoded(const DriveVelocity& velocity,
                                          std::chrono::nanoseconds clockAhead) const;
};

/// Returns the message for a robot that takes drive_command, otherwise that for track_command. Errors: the
/// robot takes neither, or it is tracked and its footprint has no width.
[[nodiscard]] Result<DriveMessage> driveMessageFor(const RobotDescription& robot);

}  // namespace leitstand
