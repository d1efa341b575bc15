#pragma once

#include <chrono>
#include <string>

#include "core/base/result.h"
#include "core/event/raw_event.h"
#include "core/robot/control/drive_setpoint.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// What a robot is driven with: a Twist or TwistStamped, or speeds of its tracks [m/s] in a JointState.
struct DriveMessage {
    StreamDescription stream;                                          ///< drive_command or track_command
    std::string frame;                                                 ///< of stamped commands
    double trackDistance = 0.0;                                        ///< of track commands [m]
    std::string leftTrack = "left_track", rightTrack = "right_track";  ///< joints of track commands

    /// Encodes the command for @p velocity, stamped now. @p clockAhead: robot's clock minus this computer's.
    [[nodiscard]] Result<Payload> encoded(const DriveVelocity& velocity,
                                          std::chrono::nanoseconds clockAhead) const;
};

/// Returns the message for a robot that takes drive_command, or else track_command. Errors: the robot takes
/// neither, or it is tracked and its footprint has no width.
[[nodiscard]] Result<DriveMessage> driveMessageFor(const RobotDescription& robot);

}  // namespace leitstand
