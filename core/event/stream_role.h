#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace leitstand {

/// What a topic of a robot contains for the station. Checkpoints of missions store the numbers, so a new role
/// gets the next unused number, wherever it is listed.
enum class StreamRole : std::uint8_t {
    // from the robot
    Points = 0,
    Ranges = 1,
    Odometry = 2,
    Imu = 3,
    Joints = 4,
    Transforms = 5,
    StaticTransforms = 6,
    Picture = 7,
    CameraInfo = 8,
    Thermal = 9,
    Gas = 10,
    Battery = 11,
    Diagnostics = 12,
    Mode = 13,
    Bumps = 14,
    Sightings = 15,
    StopState = 16,
    Pong = 17,
    Grid = 26,
    GridUpdate = 27,
    Path = 28,
    Reading = 31,
    Markers = 32,
    Model = 33,
    Detections = 34,
    // to the robot
    DriveCommand = 18,
    TrackCommand = 19,
    StopCommand = 20,
    ModeCommand = 21,
    GoalPose = 22,
    PanTiltCommand = 23,
    StreamCommand = 24,
    Ping = 25,
    StopLock = 29,
    JointCommand = 30,
};

/// The name of @p role in robot files: "points", "drive_command"; empty if the number is no role.
[[nodiscard]] constexpr std::string_view nameOf(StreamRole role) {
    switch (role) {
        case StreamRole::Points:
            return "points";
        case StreamRole::Ranges:
            return "ranges";
        case StreamRole::Odometry:
            return "odometry";
        case StreamRole::Imu:
            return "imu";
        case StreamRole::Joints:
            return "joints";
        case StreamRole::Transforms:
            return "transforms";
        case StreamRole::StaticTransforms:
            return "static_transforms";
        case StreamRole::Picture:
            return "picture";
        case StreamRole::CameraInfo:
            return "camera_info";
        case StreamRole::Thermal:
            return "thermal";
        case StreamRole::Gas:
            return "gas";
        case StreamRole::Battery:
            return "battery";
        case StreamRole::Diagnostics:
            return "diagnostics";
        case StreamRole::Mode:
            return "mode";
        case StreamRole::Bumps:
            return "bumps";
        case StreamRole::Sightings:
            return "sightings";
        case StreamRole::StopState:
            return "stop_state";
        case StreamRole::Pong:
            return "pong";
        case StreamRole::Grid:
            return "grid";
        case StreamRole::GridUpdate:
            return "grid_update";
        case StreamRole::Path:
            return "path";
        case StreamRole::Reading:
            return "reading";
        case StreamRole::Markers:
            return "markers";
        case StreamRole::Model:
            return "model";
        case StreamRole::Detections:
            return "detections";
        case StreamRole::DriveCommand:
            return "drive_command";
        case StreamRole::TrackCommand:
            return "track_command";
        case StreamRole::StopCommand:
            return "stop_command";
        case StreamRole::ModeCommand:
            return "mode_command";
        case StreamRole::GoalPose:
            return "goal_pose";
        case StreamRole::PanTiltCommand:
            return "pan_tilt_command";
        case StreamRole::StreamCommand:
            return "stream_command";
        case StreamRole::Ping:
            return "ping";
        case StreamRole::StopLock:
            return "stop_lock";
        case StreamRole::JointCommand:
            return "joint_command";
    }
    return {};
}

/// Roles of the topics that the station sends.
inline constexpr auto CommandRoles = std::to_array<StreamRole>(
    {StreamRole::DriveCommand, StreamRole::TrackCommand, StreamRole::StopCommand, StreamRole::ModeCommand,
     StreamRole::GoalPose, StreamRole::PanTiltCommand, StreamRole::StreamCommand, StreamRole::Ping,
     StreamRole::StopLock, StreamRole::JointCommand});

/// Whether the station sends topics of @p role.
[[nodiscard]] bool isCommand(StreamRole role);
/// All roles, by rising number.
[[nodiscard]] std::span<const StreamRole> allStreamRoles();
/// The text of nameOf().
[[nodiscard]] std::string toString(StreamRole role);

}  // namespace leitstand
