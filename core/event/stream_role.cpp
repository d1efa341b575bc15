#include "core/event/stream_role.h"

#include <array>
#include <cstddef>

namespace leitstand {

bool isCommand(StreamRole role) {
    return role >= StreamRole::DriveCommand;
}

std::span<const StreamRole> allStreamRoles() {
    static constexpr auto All = [] {
        std::array<StreamRole, static_cast<std::size_t>(StreamRole::Ping) + 1> roles{};
        for (std::size_t i = 0; i < roles.size(); ++i) roles[i] = static_cast<StreamRole>(i);
        return roles;
    }();
    return All;
}

std::string toString(StreamRole role) {
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
    }
    return {};
}

}  // namespace leitstand
