#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace leitstand {

/// What a topic of a robot carries for the station.
enum class StreamRole : std::uint8_t {
    // from the robot
    Points,
    Ranges,
    Odometry,
    Imu,
    Joints,
    Transforms,
    StaticTransforms,
    Picture,
    CameraInfo,
    Thermal,
    Gas,
    Battery,
    Diagnostics,
    Mode,
    Bumps,
    Sightings,
    StopState,
    Pong,
    // to the robot
    DriveCommand,
    TrackCommand,
    StopCommand,
    ModeCommand,
    GoalPose,
    PanTiltCommand,
    StreamCommand,
    Ping,
};

/// Whether the station sends topics of @p role.
[[nodiscard]] bool isCommand(StreamRole role);
/// All roles, in the order of their declaration.
[[nodiscard]] std::span<const StreamRole> allStreamRoles();
/// The name of @p role in robot files: "points", "drive_command".
[[nodiscard]] std::string toString(StreamRole role);

}  // namespace leitstand
