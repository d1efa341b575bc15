#include "core/robot/streams/stream_table.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/base/words.h"
#include "core/event/stream_role.h"
#include "core/robot/robot_description.h"

namespace leitstand {
namespace {

using Type = std::string_view;

constexpr Type Cloud[] = {"sensor_msgs/msg/PointCloud2", "livox_ros_driver2/msg/CustomMsg",
                          // depths, with a camera_info of the same sensor
                          "sensor_msgs/msg/CompressedImage", "sensor_msgs/msg/Image"};
constexpr Type Scan[] = {"sensor_msgs/msg/LaserScan"};
constexpr Type Odom[] = {"nav_msgs/msg/Odometry"};
constexpr Type Inertia[] = {"sensor_msgs/msg/Imu"};
constexpr Type Joint[] = {"sensor_msgs/msg/JointState"};
constexpr Type Transform[] = {"tf2_msgs/msg/TFMessage"};
constexpr Type Image[] = {"sensor_msgs/msg/CompressedImage", "sensor_msgs/msg/Image",
                          "ffmpeg_image_transport_msgs/msg/FFMPEGPacket",
                          "foxglove_msgs/msg/CompressedVideo"};
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
constexpr Type ModeRequest[] = {"leitstand_msgs/msg/ModeCommand"};
constexpr Type Goal[] = {"geometry_msgs/msg/PoseStamped"};
constexpr Type StreamOrder[] = {"leitstand_msgs/msg/StreamCommand"};
constexpr Type Occupancy[] = {"nav_msgs/msg/OccupancyGrid"};
constexpr Type OccupancyChange[] = {"map_msgs/msg/OccupancyGridUpdate"};
constexpr Type Flag[] = {"std_msgs/msg/Bool"};
constexpr Type JointOrder[] = {"trajectory_msgs/msg/JointTrajectory", "std_msgs/msg/Float64MultiArray",
                               "sensor_msgs/msg/JointState"};
constexpr Type PlannedPath[] = {"nav_msgs/msg/Path"};
constexpr Type Readings[] = {"sensor_msgs/msg/Temperature",   "sensor_msgs/msg/RelativeHumidity",
                             "sensor_msgs/msg/FluidPressure", "sensor_msgs/msg/MagneticField",
                             "sensor_msgs/msg/Range",         "sensor_msgs/msg/Illuminance",
                             "sensor_msgs/msg/NavSatFix"};
constexpr Type Drawings[] = {
    "visualization_msgs/msg/MarkerArray", "visualization_msgs/msg/Marker", "geometry_msgs/msg/PolygonStamped",
    "geometry_msgs/msg/PoseWithCovarianceStamped", "vision_msgs/msg/Detection3DArray"};
constexpr Type Model[] = {"std_msgs/msg/String"};
constexpr Type Detections[] = {"vision_msgs/msg/Detection2DArray"};
constexpr Type Question[] = {"leitstand_msgs/msg/Ping"};

constexpr std::string_view OfHeat[] = {"ir", "thermal", "lepton", "flir"};
constexpr std::string_view OfGas[] = {"co2", "gas"};
constexpr std::string_view OfDriving[] = {"cmd", "command"};
constexpr std::string_view OfGoals[] = {"goal"};

constexpr Qos qos(Qos::Reliability reliability, Qos::Durability durability, int depth,
                  double lifespan = 0.0) {
    return {reliability, durability, depth, lifespan, 0.0};
}
constexpr Qos::Reliability BestEffort = Qos::Reliability::BestEffort, Reliable = Qos::Reliability::Reliable;
constexpr Qos::Durability Volatile = Qos::Durability::Volatile, Stays = Qos::Durability::TransientLocal;
constexpr Qos Steady = qos(BestEffort, Volatile, 10), OnChange = qos(Reliable, Stays, 10);
constexpr Qos Command = qos(Reliable, Volatile, 1), Stick = qos(Reliable, Volatile, 1, 0.2);

constexpr StreamFacts Table[] = {
    // from the robot
    {.role = StreamRole::Points,
     .title = translatable("leitstand::LinkStatus", "3D scans"),
     .types = Cloud,
     .topic = "points",
     .qos = qos(Reliable, Volatile, 600),
     .steady = true,
     .quick = true,
     .needed = true,
     .several = true,
     .sight = Sight::Scanner,
     .stampRank = 4,
     .thinRank = ThinRank::Scans,
     .usualRate = 10.0,
     .usualMegabits = 1.5,
     .thinnedAs = ThinnedAs::Cloud},
    {.role = StreamRole::Ranges,
     .title = translatable("leitstand::LinkStatus", "laser"),
     .types = Scan,
     .topic = "scan",
     .qos = Steady,
     .steady = true,
     .quick = true,
     .needed = true,
     .sight = Sight::Scanner,
     .stampRank = 3,
     .thinRank = ThinRank::Scans,
     .usualRate = 10.0,
     .usualMegabits = 0.3,
     .thinnedAs = ThinnedAs::Ranges},
    {.role = StreamRole::Odometry,
     .title = translatable("leitstand::LinkStatus", "odometry"),
     .types = Odom,
     .topic = "odom",
     .qos = Steady,
     .single = true,
     .steady = true,
     .quick = true,
     .alwaysOn = true,
     .needed = true,
     .indexed = true,
     .stampRank = 0,
     .usualRate = 30.0,
     .usualMegabits = 0.05,
     .thinnedAs = ThinnedAs::Motion},
    {.role = StreamRole::Imu,
     .title = translatable("leitstand::LinkStatus", "attitude"),
     .types = Inertia,
     .topic = "imu",
     .qos = Steady,
     .steady = true,
     .quick = true,
     .alwaysOn = true,
     .needed = true,
     .stampRank = 1,
     .thinRank = ThinRank::Telemetry,
     .usualRate = 30.0,
     .usualMegabits = 0.05,
     .thinnedAs = ThinnedAs::Other,
     .inLog = "IMU"},
    {.role = StreamRole::Joints,
     .title = translatable("leitstand::LinkStatus", "joints"),
     .types = Joint,
     .topic = "joint_states",
     .qos = Steady,
     .steady = true,
     .quick = true,
     .stampRank = 2,
     .thinRank = ThinRank::Telemetry,
     .usualRate = 30.0,
     .usualMegabits = 0.05,
     .thinnedAs = ThinnedAs::Other},
    {.role = StreamRole::Transforms,
     .title = translatable("leitstand::LinkStatus", "transforms"),
     .types = Transform,
     .topic = "tf",
     .qos = Steady,
     .shared = true,
     .steady = true,
     .quick = true,
     .thinRank = ThinRank::Telemetry,
     .usualRate = 30.0,
     .usualMegabits = 0.05,
     .thinnedAs = ThinnedAs::Motion},
    {.role = StreamRole::StaticTransforms,
     .title = translatable("leitstand::LinkStatus", "fixed transforms"),
     .types = Transform,
     .topic = "tf_static",
     .qos = qos(Reliable, Stays, 100),
     .shared = true,
     .indexed = true,
     .inLog = "static transforms",
     .guessedBy = GuessedBy::Name},
    {.role = StreamRole::Picture,
     .title = translatable("leitstand::LinkStatus", "pictures"),
     .types = Image,
     .topic = "image/compressed",
     .qos = Steady,
     .ofCamera = true,
     .picture = true,
     .steady = true,
     .quick = true,
     .thinRank = ThinRank::Pictures,
     .usualRate = 10.0,
     .usualMegabits = 1.2,
     .thinnedAs = ThinnedAs::Picture,
     .inLog = "pictures"},
    {.role = StreamRole::CameraInfo,
     .title = translatable("leitstand::LinkStatus", "camera data"),
     .types = Info,
     .topic = "camera_info",
     .qos = Steady,
     .ofCamera = true,
     .steady = true,
     .quick = true,
     .thinRank = ThinRank::Telemetry,
     .thinnedAs = ThinnedAs::Other,
     .inLog = "camera info"},
    {.role = StreamRole::Thermal,
     .title = translatable("leitstand::LinkStatus", "infrared"),
     .types = Image,
     .topic = "image/compressed",
     .qos = Steady,
     .ofCamera = true,
     .picture = true,
     .steady = true,
     .quick = true,
     .thinRank = ThinRank::Pictures,
     .usualRate = 9.0,
     .usualMegabits = 1.2,
     .thinnedAs = ThinnedAs::Picture,
     .inLog = "thermal pictures",
     .guessedBy = GuessedBy::Words,
     .words = OfHeat},
    {.role = StreamRole::Gas,
     .title = translatable("leitstand::LinkStatus", "gas"),
     .types = Gases,
     .topic = "co2",
     .qos = Steady,
     .steady = true,
     .needed = true,
     .indexed = true,
     .words = OfGas},
    {.role = StreamRole::Battery,
     .title = translatable("leitstand::LinkStatus", "battery"),
     .types = Batteries,
     .topic = "battery_state",
     .qos = Steady,
     .steady = true,
     .needed = true,
     .stampRank = 5},
    {.role = StreamRole::Diagnostics,
     .title = translatable("leitstand::LinkStatus", "diagnostics"),
     .types = Diagnostic,
     .topic = "/diagnostics",
     .qos = Steady,
     .shared = true,
     .steady = true},
    {.role = StreamRole::Mode,
     .title = translatable("leitstand::LinkStatus", "mode"),
     .types = Modes,
     .topic = "mode",
     .qos = OnChange,
     .single = true,
     .indexed = true,
     .guessedBy = GuessedBy::Name},
    {.role = StreamRole::Bumps,
     .title = translatable("leitstand::LinkStatus", "contacts"),
     .types = Bumpers,
     .topic = "bumps",
     .qos = OnChange,
     .single = true,
     .indexed = true,
     .guessedBy = GuessedBy::Name},
    {.role = StreamRole::Sightings,
     .title = translatable("leitstand::LinkStatus", "sightings"),
     .types = Seen,
     .topic = "sightings",
     .qos = OnChange,
     .single = true,
     .indexed = true,
     .guessedBy = GuessedBy::Name},
    {.role = StreamRole::StopState,
     .title = translatable("leitstand::LinkStatus", "STOP"),
     .types = Stopped,
     .topic = "stop_state",
     .qos = OnChange,
     .single = true,
     .inLog = "stop state",
     .guessedBy = GuessedBy::Name},
    {.role = StreamRole::Pong,
     .types = Answer,
     .topic = "pong",
     .qos = qos(Reliable, Volatile, 10),
     .single = true,
     .thinnedAs = ThinnedAs::Other,
     .guessedBy = GuessedBy::Name},
    // to the robot
    {.role = StreamRole::DriveCommand,
     .types = Velocity,
     .topic = "cmd_vel",
     .qos = Stick,
     .single = true,
     .thinnedAs = ThinnedAs::Other,
     .guessedBy = GuessedBy::Words,
     .words = OfDriving},
    {.role = StreamRole::TrackCommand,
     .types = Joint,
     .topic = "track_cmd",
     .qos = Stick,
     .single = true,
     .thinnedAs = ThinnedAs::Other,
     .guessedBy = GuessedBy::Name},
    {.role = StreamRole::StopCommand,
     .types = Stop,
     .topic = "stop_cmd",
     .qos = qos(Reliable, Stays, 1),
     .single = true,
     .guessedBy = GuessedBy::Name},
    {.role = StreamRole::ModeCommand,
     .types = ModeRequest,
     .topic = "mode_cmd",
     .qos = Command,
     .single = true,
     .guessedBy = GuessedBy::Name},
    {.role = StreamRole::GoalPose,
     .types = Goal,
     .topic = "goal_pose",
     .qos = Command,
     .single = true,
     .guessedBy = GuessedBy::Words,
     .words = OfGoals},
    {.role = StreamRole::PanTiltCommand,
     .types = Joint,
     .topic = "ptu_cmd",
     .qos = Command,
     .single = true,
     .guessedBy = GuessedBy::Name},
    {.role = StreamRole::StreamCommand,
     .types = StreamOrder,
     .topic = "stream_cmd",
     .qos = Command,
     .single = true,
     .guessedBy = GuessedBy::Name},
    {.role = StreamRole::Ping,
     .types = Question,
     .topic = "ping",
     .qos = Command,
     .single = true,
     .thinnedAs = ThinnedAs::Other,
     .guessedBy = GuessedBy::Name},
    // from the robot's navigation
    {.role = StreamRole::Grid,
     .title = translatable("leitstand::LinkStatus", "its own map"),
     .types = Occupancy,
     .topic = "map",
     .qos = qos(Reliable, Stays, 1),
     .thinRank = ThinRank::Scans,
     .usualMegabits = 0.5,
     .thinnedAs = ThinnedAs::Other,
     .inLog = "grid maps",
     .guessedBy = GuessedBy::Name},
    {.role = StreamRole::GridUpdate,
     .title = translatable("leitstand::LinkStatus", "changes of its map"),
     .types = OccupancyChange,
     .topic = "map_updates",
     .qos = qos(Reliable, Volatile, 10),
     .thinRank = ThinRank::Scans,
     .usualMegabits = 0.1,
     .thinnedAs = ThinnedAs::Other,
     .inLog = "changes of grid maps",
     .guessedBy = GuessedBy::Name},
    {.role = StreamRole::Path,
     .title = translatable("leitstand::LinkStatus", "its planned path"),
     .types = PlannedPath,
     .topic = "plan",
     .qos = qos(Reliable, Volatile, 10),
     .thinRank = ThinRank::Telemetry,
     .usualMegabits = 0.05,
     .thinnedAs = ThinnedAs::Other,
     .inLog = "planned paths",
     .guessedBy = GuessedBy::Name},
    // to the robot
    {.role = StreamRole::StopLock,
     .types = Flag,
     .topic = "stop_lock",
     .qos = Command,
     .single = true,
     .guessedBy = GuessedBy::Name},
    {.role = StreamRole::JointCommand,
     .types = JointOrder,
     .topic = "joint_trajectory",
     .qos = Stick,
     .several = true,
     .thinnedAs = ThinnedAs::Other,
     .guessedBy = GuessedBy::Name},
    // from the robot
    {.role = StreamRole::Reading,
     .title = translatable("leitstand::LinkStatus", "readings"),
     .types = Readings,
     .anyType = true,
     .topic = "reading",
     .qos = Steady,
     .steady = true,
     .several = true,
     .indexed = true,
     .thinRank = ThinRank::Telemetry},
    {.role = StreamRole::Markers,
     .title = translatable("leitstand::LinkStatus", "what it draws"),
     .types = Drawings,
     .topic = "markers",
     .qos = qos(Reliable, Volatile, 10),
     .several = true,
     .thinRank = ThinRank::Telemetry,
     .usualMegabits = 0.05},
    {.role = StreamRole::Model,
     .title = translatable("leitstand::LinkStatus", "its model"),
     .types = Model,
     .topic = "robot_description",
     .qos = qos(Reliable, Stays, 1),
     .single = true,
     .usualRate = 0.0,
     .guessedBy = GuessedBy::Name},
    {.role = StreamRole::Detections,
     .title = translatable("leitstand::LinkStatus", "what it sees in pictures"),
     .types = Detections,
     .topic = "detections",
     .qos = qos(Reliable, Volatile, 10),
     .several = true,
     .thinRank = ThinRank::Telemetry,
     .usualMegabits = 0.02},
};

/// Whether each row is at the index of its role.
constexpr bool isInOrder() {
    for (std::size_t i = 0; i < std::size(Table); ++i) {
        if (Table[i].role != static_cast<StreamRole>(i) || Table[i].types.empty() || Table[i].topic.empty())
            return false;
    }
    return true;
}
static_assert(nameOf(static_cast<StreamRole>(std::size(Table))).empty(), "a row for each role");
static_assert(isInOrder(), "rows by rising number of their roles, each with types and a topic");

}  // namespace

std::span<const StreamFacts> streamTable() {
    return Table;
}

const StreamFacts& streamFacts(StreamRole role) {
    return Table[static_cast<std::size_t>(role)];
}

bool isScanner(StreamRole role) {
    return streamFacts(role).sight == Sight::Scanner;
}

bool isDepthStream(const StreamDescription& stream) {
    return stream.role == StreamRole::Points && isPictureType(stream.type);
}

bool isPictureType(std::string_view type) {
    return std::find(std::begin(Image), std::end(Image), type) != std::end(Image);
}

std::span<const std::string_view> typesOf(StreamRole role) {
    return streamFacts(role).types;
}

}  // namespace leitstand
