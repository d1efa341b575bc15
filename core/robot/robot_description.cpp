#include "core/robot/robot_description.h"

#include <algorithm>
#include <array>

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

std::string toString(StampSource source) {
    switch (source) {
        case StampSource::Robot:
            return "robot";
        case StampSource::Zero:
            return "zero";
        case StampSource::Station:
            return "station";
    }
    return {};
}

std::string toString(TfPrefix prefix) {
    switch (prefix) {
        case TfPrefix::Topic:
            return "topic";
        case TfPrefix::Frame:
            return "frame";
        case TfPrefix::None:
            return "none";
    }
    return {};
}

std::string toString(SensorMotion motion) {
    switch (motion) {
        case SensorMotion::Unsaid:
            return "unsaid";
        case SensorMotion::Fixed:
            return "fixed";
        case SensorMotion::Turning:
            return "turning";
        case SensorMotion::Tilting:
            return "tilting";
    }
    return {};
}

std::string toString(DriveType drive) {
    switch (drive) {
        case DriveType::Differential:
            return "differential";
        case DriveType::Tracked:
            return "tracked";
        case DriveType::Omnidirectional:
            return "omnidirectional";
    }
    return {};
}

std::string toString(LinkLossRule rule) {
    switch (rule) {
        case LinkLossRule::Stop:
            return "stop";
        case LinkLossRule::FinishAndWait:
            return "finish_and_wait";
        case LinkLossRule::ReturnToLink:
            return "return_to_link";
    }
    return {};
}

const StreamDescription* RobotDescription::stream(StreamRole role, const std::string& sensor) const {
    const auto found = std::find_if(streams.begin(), streams.end(), [&](const StreamDescription& stream) {
        return stream.role == role && (sensor.empty() || stream.sensor == sensor);
    });
    return found == streams.end() ? nullptr : &*found;
}

}  // namespace leitstand
