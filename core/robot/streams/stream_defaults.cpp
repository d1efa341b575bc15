#include "core/robot/streams/stream_defaults.h"

#include <string_view>

#include <fmt/format.h>

#include "core/robot/streams/stream_types.h"

namespace leitstand {
namespace {

constexpr Qos::Reliability BestEffort = Qos::Reliability::BestEffort, Reliable = Qos::Reliability::Reliable;
constexpr Qos::Durability Volatile = Qos::Durability::Volatile, Stays = Qos::Durability::TransientLocal;

struct Default {
    std::string_view leaf;  ///< below the robot's namespace, or with a slash as it is
    Qos qos;
};

Default defaultOf(StreamRole role) {
    const auto qos = [](Qos::Reliability reliability, Qos::Durability durability, int depth,
                        double lifespan = 0.0) {
        return Qos{reliability, durability, depth, lifespan, 0.0};
    };
    const Qos steady = qos(BestEffort, Volatile, 10), onChange = qos(Reliable, Stays, 10);
    const Qos command = qos(Reliable, Volatile, 1);
    switch (role) {
        case StreamRole::Points:
            return {"points", qos(Reliable, Volatile, 600)};
        case StreamRole::Ranges:
            return {"scan", steady};
        case StreamRole::Odometry:
            return {"odom", steady};
        case StreamRole::Imu:
            return {"imu", steady};
        case StreamRole::Joints:
            return {"joint_states", steady};
        case StreamRole::Transforms:
            return {"tf", steady};
        case StreamRole::StaticTransforms:
            return {"tf_static", qos(Reliable, Stays, 100)};
        case StreamRole::Picture:
            return {"image/compressed", steady};
        case StreamRole::CameraInfo:
            return {"camera_info", steady};
        case StreamRole::Thermal:
            return {"image/compressed", steady};
        case StreamRole::Gas:
            return {"co2", steady};
        case StreamRole::Battery:
            return {"battery_state", steady};
        case StreamRole::Diagnostics:
            return {"/diagnostics", steady};
        case StreamRole::Mode:
            return {"mode", onChange};
        case StreamRole::Bumps:
            return {"bumps", onChange};
        case StreamRole::Sightings:
            return {"sightings", onChange};
        case StreamRole::StopState:
            return {"stop_state", onChange};
        case StreamRole::Pong:
            return {"pong", qos(Reliable, Volatile, 10)};
        case StreamRole::DriveCommand:
            return {"cmd_vel", qos(Reliable, Volatile, 1, 0.2)};
        case StreamRole::TrackCommand:
            return {"track_cmd", qos(Reliable, Volatile, 1, 0.2)};
        case StreamRole::StopCommand:
            return {"stop_cmd", qos(Reliable, Stays, 1)};
        case StreamRole::ModeCommand:
            return {"mode_cmd", command};
        case StreamRole::GoalPose:
            return {"goal_pose", command};
        case StreamRole::PanTiltCommand:
            return {"ptu_cmd", command};
        case StreamRole::StreamCommand:
            return {"stream_cmd", command};
        case StreamRole::Ping:
            return {"ping", command};
    }
    return {};
}

/// /tf, where robots do not have one of their own.
bool isShared(StreamRole role, TfPrefix prefix) {
    return (role == StreamRole::Transforms || role == StreamRole::StaticTransforms) &&
           prefix != TfPrefix::Topic;
}

}  // namespace

bool belongsToCamera(StreamRole role) {
    return role == StreamRole::Picture || role == StreamRole::CameraInfo || role == StreamRole::Thermal;
}

StreamDescription defaultStream(StreamRole role, const std::string& robot, const std::string& sensor,
                                TfPrefix prefix) {
    const Default chosen = defaultOf(role);
    StreamDescription stream;
    stream.role = role;
    stream.sensor = sensor;
    if (chosen.leaf.starts_with('/')) {
        stream.topic = chosen.leaf;
    } else {
        const std::string space = isShared(role, prefix) ? std::string() : robot + "/";
        const std::string camera = sensor.empty() ? std::string("camera") : sensor;
        stream.topic =
            fmt::format("/{}{}{}", space, belongsToCamera(role) ? camera + "/" : std::string(), chosen.leaf);
    }
    stream.type = typesOf(role).front();
    stream.qos = chosen.qos;
    if (role == StreamRole::Diagnostics) stream.hardwareId = robot;
    return stream;
}

}  // namespace leitstand
