#include "core/robot/streams/stream_types.h"

namespace leitstand {
namespace {

using Type = std::string_view;

constexpr Type Cloud[] = {"sensor_msgs/msg/PointCloud2"};
constexpr Type Scan[] = {"sensor_msgs/msg/LaserScan"};
constexpr Type Odom[] = {"nav_msgs/msg/Odometry"};
constexpr Type Inertia[] = {"sensor_msgs/msg/Imu"};
constexpr Type Joint[] = {"sensor_msgs/msg/JointState"};
constexpr Type Transform[] = {"tf2_msgs/msg/TFMessage"};
constexpr Type Image[] = {"sensor_msgs/msg/CompressedImage", "sensor_msgs/msg/Image"};
constexpr Type Info[] = {"sensor_msgs/msg/CameraInfo"};
constexpr Type Gases[] = {"leitstand_msgs/msg/GasConcentration", "std_msgs/msg/Float32",
                          "std_msgs/msg/Float64"};
constexpr Type Batteries[] = {"sensor_msgs/msg/BatteryState"};
constexpr Type Diagnostic[] = {"diagnostic_msgs/msg/DiagnosticArray"};
constexpr Type Modes[] = {"leitstand_msgs/msg/Mode"};
constexpr Type Bumpers[] = {"leitstand_msgs/msg/Bumps"};
constexpr Type Seen[] = {"leitstand_msgs/msg/Sightings"};
constexpr Type Stopped[] = {"leitstand_msgs/msg/StopState"};
constexpr Type Answer[] = {"leitstand_msgs/msg/Pong"};
constexpr Type Velocity[] = {"geometry_msgs/msg/Twist", "geometry_msgs/msg/TwistStamped"};
constexpr Type Stop[] = {"leitstand_msgs/msg/StopCommand"};
constexpr Type ModeWish[] = {"leitstand_msgs/msg/ModeCommand"};
constexpr Type Goal[] = {"geometry_msgs/msg/PoseStamped"};
constexpr Type StreamWish[] = {"leitstand_msgs/msg/StreamCommand"};
constexpr Type Question[] = {"leitstand_msgs/msg/Ping"};

}  // namespace

std::span<const std::string_view> typesOf(StreamRole role) {
    switch (role) {
        case StreamRole::Points:
            return Cloud;
        case StreamRole::Ranges:
            return Scan;
        case StreamRole::Odometry:
            return Odom;
        case StreamRole::Imu:
            return Inertia;
        case StreamRole::Joints:
        case StreamRole::TrackCommand:
        case StreamRole::PanTiltCommand:
            return Joint;
        case StreamRole::Transforms:
        case StreamRole::StaticTransforms:
            return Transform;
        case StreamRole::Picture:
        case StreamRole::Thermal:
            return Image;
        case StreamRole::CameraInfo:
            return Info;
        case StreamRole::Gas:
            return Gases;
        case StreamRole::Battery:
            return Batteries;
        case StreamRole::Diagnostics:
            return Diagnostic;
        case StreamRole::Mode:
            return Modes;
        case StreamRole::Bumps:
            return Bumpers;
        case StreamRole::Sightings:
            return Seen;
        case StreamRole::StopState:
            return Stopped;
        case StreamRole::Pong:
            return Answer;
        case StreamRole::DriveCommand:
            return Velocity;
        case StreamRole::StopCommand:
            return Stop;
        case StreamRole::ModeCommand:
            return ModeWish;
        case StreamRole::GoalPose:
            return Goal;
        case StreamRole::StreamCommand:
            return StreamWish;
        case StreamRole::Ping:
            return Question;
    }
    return {};
}

}  // namespace leitstand
