#include "core/robot/stream_defaults.h"

#include <string_view>

namespace leitstand {
namespace {

constexpr Qos::Reliability BestEffort = Qos::Reliability::BestEffort, Reliable = Qos::Reliability::Reliable;
constexpr Qos::Durability Volatile = Qos::Durability::Volatile, Stays = Qos::Durability::TransientLocal;

struct Default {
    std::string_view leaf, type;
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
            return {"points", "sensor_msgs/msg/PointCloud2", qos(Reliable, Volatile, 600)};
        case StreamRole::Ranges:
            return {"scan", "sensor_msgs/msg/LaserScan", steady};
        case StreamRole::Odometry:
            return {"odom", "nav_msgs/msg/Odometry", steady};
        case StreamRole::Imu:
            return {"imu", "sensor_msgs/msg/Imu", steady};
        case StreamRole::Joints:
            return {"joint_states", "sensor_msgs/msg/JointState", steady};
        case StreamRole::Transforms:
            return {"tf", "tf2_msgs/msg/TFMessage", steady};
        case StreamRole::StaticTransforms:
            return {"tf_static", "tf2_msgs/msg/TFMessage", qos(Reliable, Stays, 100)};
        case StreamRole::Picture:
            return {"image/compressed", "sensor_msgs/msg/CompressedImage", steady};
        case StreamRole::CameraInfo:
            return {"camera_info", "sensor_msgs/msg/CameraInfo", steady};
        case StreamRole::Thermal:
            return {"image/compressed", "sensor_msgs/msg/CompressedImage", steady};
        case StreamRole::Gas:
            return {"co2", "leitstand_msgs/msg/GasConcentration", steady};
        case StreamRole::Battery:
            return {"battery_state", "sensor_msgs/msg/BatteryState", steady};
        case StreamRole::Diagnostics:
            return {"/diagnostics", "diagnostic_msgs/msg/DiagnosticArray", steady};
        case StreamRole::Mode:
            return {"mode", "leitstand_msgs/msg/Mode", onChange};
        case StreamRole::Bumps:
            return {"bumps", "leitstand_msgs/msg/Bumps", onChange};
        case StreamRole::Sightings:
            return {"sightings", "leitstand_msgs/msg/Sightings", onChange};
        case StreamRole::StopState:
            return {"stop_state", "leitstand_msgs/msg/StopState", onChange};
        case StreamRole::Pong:
            return {"pong", "leitstand_msgs/msg/Pong", qos(Reliable, Volatile, 10)};
        case StreamRole::DriveCommand:
            return {"cmd_vel", "geometry_msgs/msg/Twist", qos(Reliable, Volatile, 1, 0.3)};
        case StreamRole::TrackCommand:
            return {"track_cmd", "sensor_msgs/msg/JointState", qos(Reliable, Volatile, 1, 0.3)};
        case StreamRole::StopCommand:
            return {"stop_cmd", "leitstand_msgs/msg/StopCommand", qos(Reliable, Stays, 1)};
        case StreamRole::ModeCommand:
            return {"mode_cmd", "leitstand_msgs/msg/ModeCommand", command};
        case StreamRole::GoalPose:
            return {"goal_pose", "geometry_msgs/msg/PoseStamped", command};
        case StreamRole::PanTiltCommand:
            return {"ptu_cmd", "sensor_msgs/msg/JointState", command};
        case StreamRole::StreamCommand:
            return {"stream_cmd", "leitstand_msgs/msg/StreamCommand", command};
        case StreamRole::Ping:
            return {"ping", "leitstand_msgs/msg/Ping", command};
    }
    return {};
}

bool belongsToCamera(StreamRole role) {
    return role == StreamRole::Picture || role == StreamRole::CameraInfo || role == StreamRole::Thermal;
}

}  // namespace

StreamDescription defaultStream(StreamRole role, const std::string& robot, const std::string& sensor) {
    const Default chosen = defaultOf(role);
    StreamDescription stream;
    stream.role = role;
    stream.sensor = sensor;
    if (chosen.leaf.starts_with('/')) {
        stream.topic = chosen.leaf;
    } else {
        stream.topic = "/" + robot + "/";
        if (belongsToCamera(role)) stream.topic += (sensor.empty() ? std::string("camera") : sensor) + "/";
        stream.topic += chosen.leaf;
    }
    stream.type = chosen.type;
    stream.qos = chosen.qos;
    if (role == StreamRole::Diagnostics) stream.hardwareId = robot;
    return stream;
}

}  // namespace leitstand
