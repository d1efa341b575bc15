#include "robots/simulation/stock/stock_profile.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "core/io/robot/robot_file.h"
#include "core/io/settings/folders.h"

namespace leitstand::simulation {
namespace {

using namespace std::chrono_literals;

constexpr Qos qos(Qos::Reliability reliability, Qos::Durability durability, int depth) {
    return {reliability, durability, depth, 0.0, 0.0};
}
constexpr Qos SensorData = qos(Qos::Reliability::BestEffort, Qos::Durability::Volatile, 5);
constexpr Qos Default = qos(Qos::Reliability::Reliable, Qos::Durability::Volatile, 10);
constexpr Qos Latched = qos(Qos::Reliability::Reliable, Qos::Durability::TransientLocal, 1);

// TurtleBot 4 user manual, tutorials/multiple_robots.md (names) and software/turtlebot4_robot.md (types);
// create3_docs, "ROS 2 interfaces"; depthai_ros_driver; nav2_bringup.
constexpr StockTopic Turtlebot4[] = {
    {"/rosout", "rcl_interfaces/msg/Log", Latched, 1.0},
    {"/parameter_events", "rcl_interfaces/msg/ParameterEvent", Default, 0.0},
    {"robot_description", "std_msgs/msg/String", Latched, 0.0},
    {"joint_states", "sensor_msgs/msg/JointState", SensorData, 20.0},
    {"dock_status", "irobot_create_msgs/msg/DockStatus", SensorData, 1.0},
    {"hazard_detection", "irobot_create_msgs/msg/HazardDetectionVector", SensorData, 20.0},
    {"interface_buttons", "irobot_create_msgs/msg/InterfaceButtons", SensorData, 1.0},
    {"ip", "std_msgs/msg/String", Default, 1.0},
    {"ir_intensity", "irobot_create_msgs/msg/IrIntensityVector", SensorData, 20.0},
    {"ir_opcode", "irobot_create_msgs/msg/IrOpcode", SensorData, 0.0},
    {"kidnap_status", "irobot_create_msgs/msg/KidnapStatus", SensorData, 1.0},
    {"mouse", "irobot_create_msgs/msg/Mouse", SensorData, 20.0},
    {"slip_status", "irobot_create_msgs/msg/SlipStatus", SensorData, 1.0},
    {"stop_status", "irobot_create_msgs/msg/StopStatus", SensorData, 1.0},
    {"wheel_status", "irobot_create_msgs/msg/WheelStatus", SensorData, 10.0},
    {"wheel_ticks", "irobot_create_msgs/msg/WheelTicks", SensorData, 20.0},
    {"wheel_vels", "irobot_create_msgs/msg/WheelVels", SensorData, 20.0},
    {"joy", "sensor_msgs/msg/Joy", Default, 0.0},
    {"diagnostics_agg", "diagnostic_msgs/msg/DiagnosticArray", Default, 1.0},
    {"robot_state/transition_event", "lifecycle_msgs/msg/TransitionEvent", Default, 0.0},
    {"map_updates", "map_msgs/msg/OccupancyGridUpdate", Default, 0.0},
    {"plan", "nav_msgs/msg/Path", Default, 0.0},
    {"global_costmap/costmap", "nav_msgs/msg/OccupancyGrid", Latched, 0.0},
    {"local_costmap/costmap", "nav_msgs/msg/OccupancyGrid", Latched, 0.0},
    {"amcl_pose", "geometry_msgs/msg/PoseWithCovarianceStamped", Latched, 0.0},
    {"navigate_to_pose/_action/status", "action_msgs/msg/GoalStatusArray", Latched, 0.0},
};

// docs.clearpathrobotics.com: ROS 2 platform API and MCU API; velodyne_driver, velodyne_laserscan;
// twist_mux; robot_localization.
constexpr StockTopic Husky[] = {
    {"/rosout", "rcl_interfaces/msg/Log", Latched, 1.0},
    {"/parameter_events", "rcl_interfaces/msg/ParameterEvent", Default, 0.0},
    {"robot_description", "std_msgs/msg/String", Latched, 0.0},
    {"platform/cmd_vel", "geometry_msgs/msg/TwistStamped", Default, 10.0},
    {"joy_teleop/cmd_vel", "geometry_msgs/msg/TwistStamped", Default, 0.0},
    {"joy_teleop/joy", "sensor_msgs/msg/Joy", Default, 20.0},
    {"platform/dynamic_joint_states", "control_msgs/msg/DynamicJointState", Default, 50.0},
    {"platform/joint_states", "sensor_msgs/msg/JointState", Default, 50.0},
    {"platform/emergency_stop", "std_msgs/msg/Bool", SensorData, 1.0},
    {"platform/mcu/status", "clearpath_platform_msgs/msg/Status", SensorData, 1.0},
    {"platform/mcu/status/power", "clearpath_platform_msgs/msg/Power", SensorData, 10.0},
    {"platform/mcu/status/stop", "clearpath_platform_msgs/msg/StopStatus", SensorData, 1.0},
    {"platform/motors/feedback", "clearpath_platform_msgs/msg/DriveFeedback", SensorData, 20.0},
    {"platform/odom/filtered", "nav_msgs/msg/Odometry", Default, 50.0},
    {"platform/wifi_connected", "std_msgs/msg/Bool", SensorData, 1.0},
    {"diagnostics_agg", "diagnostic_msgs/msg/DiagnosticArray", Default, 1.0},
    {"sensors/imu_0/data_raw", "sensor_msgs/msg/Imu", SensorData, 50.0},
    {"sensors/lidar3d_0/velodyne_packets", "velodyne_msgs/msg/VelodyneScan", SensorData, 10.0},
    {"twist_marker_server/cmd_vel", "geometry_msgs/msg/TwistStamped", Default, 0.0},
};

// ouster_ros: driver_params.yaml (proc_mask IMU|PCL|SCAN|IMG|RAW|TLM; sensor data QoS), os_driver_node.cpp;
// ros2_controllers: diff_drive_controller.
constexpr StockTopic Ouster[] = {
    {"/rosout", "rcl_interfaces/msg/Log", Latched, 1.0},
    {"/parameter_events", "rcl_interfaces/msg/ParameterEvent", Default, 0.0},
    {"robot_description", "std_msgs/msg/String", Latched, 0.0},
    {"joint_states", "sensor_msgs/msg/JointState", Default, 50.0},
    {"dynamic_joint_states", "control_msgs/msg/DynamicJointState", Default, 50.0},
    {"ouster/metadata", "std_msgs/msg/String", Latched, 0.0},
    {"ouster/lidar_packets", "ouster_sensor_msgs/msg/PacketMsg", SensorData, 64.0},
    {"ouster/imu_packets", "ouster_sensor_msgs/msg/PacketMsg", SensorData, 100.0},
    {"ouster/telemetry", "ouster_sensor_msgs/msg/Telemetry", SensorData, 1.0},
    {"ouster/range_image", "sensor_msgs/msg/Image", SensorData, 10.0},
    {"ouster/signal_image", "sensor_msgs/msg/Image", SensorData, 10.0},
    {"ouster/reflec_image", "sensor_msgs/msg/Image", SensorData, 10.0},
    {"ouster/nearir_image", "sensor_msgs/msg/Image", SensorData, 10.0},
    {"ouster/os_driver/transition_event", "lifecycle_msgs/msg/TransitionEvent", Default, 0.0},
};

// livox_ros_driver2: lddc.cpp (topics, frames, queue sizes with the usual QoS), msg_MID360_launch.py.
constexpr StockTopic Livox[] = {
    {"/rosout", "rcl_interfaces/msg/Log", Latched, 1.0},
    {"/parameter_events", "rcl_interfaces/msg/ParameterEvent", Default, 0.0},
    {"robot_description", "std_msgs/msg/String", Latched, 0.0},
    {"joint_states", "sensor_msgs/msg/JointState", Default, 50.0},
};

// ros2_controllers: diff_drive_controller, joint_state_broadcaster, joint_trajectory_controller,
// velocity_controllers (JointGroupVelocityController); velodyne_pointcloud; ffmpeg_image_transport beside
// usb_cam.
constexpr StockTopic Tracked[] = {
    {"/rosout", "rcl_interfaces/msg/Log", Latched, 1.0},
    {"/parameter_events", "rcl_interfaces/msg/ParameterEvent", Default, 0.0},
    {"robot_description", "std_msgs/msg/String", Latched, 0.0},
    {"dynamic_joint_states", "control_msgs/msg/DynamicJointState", Default, 50.0},
    {"flipper_controller/controller_state", "control_msgs/msg/JointTrajectoryControllerState", Default, 50.0},
    {"flipper_controller/transition_event", "lifecycle_msgs/msg/TransitionEvent", Default, 0.0},
    {"arm_velocity_controller/transition_event", "lifecycle_msgs/msg/TransitionEvent", Default, 0.0},
    {"velodyne_packets", "velodyne_msgs/msg/VelodyneScan", SensorData, 10.0},
};

constexpr double StandardGravity = 9.80665;  // [m/s2]

constexpr StockProfile Profiles[] = {
    // The Create 3 stops half a second after the last command.
    {"turtlebot4", "crawler", "", 500ms, vlp16, true, 1.0, Turtlebot4},
    // cmd_vel_timeout of diff_drive_controller.
    {"husky", "kurt3d", "a200_0000", 500ms, vlp16, true, 1.0, Husky},
    {"ouster", "kurt3d", "", 500ms, os1, true, 1.0, Ouster},
    // The driver publishes no transforms, and accelerations in units of gravity.
    {"livox", "kurt3d", "", 500ms, mid360, false, StandardGravity, Livox},
    {"tracked", "crawler", "", 500ms, vlp16, true, 1.0, Tracked},
};

}  // namespace

std::vector<std::string> stockProfiles() {
    std::vector<std::string> names;
    for (const StockProfile& profile : Profiles) names.emplace_back(profile.name);
    return names;
}

const StockProfile* stockProfile(std::string_view name) {
    const auto* const found = std::find_if(std::begin(Profiles), std::end(Profiles),
                                           [&](const StockProfile& one) { return one.name == name; });
    return found == std::end(Profiles) ? nullptr : found;
}

std::string topicIn(const std::string& nameSpace, std::string_view name) {
    if (name.starts_with('/')) return std::string(name);
    return nameSpace.empty() ? fmt::format("/{}", name) : fmt::format("/{}/{}", nameSpace, name);
}

Result<RobotDescription> describe(const StockProfile& profile, const std::string& nameSpace) {
    const std::filesystem::path file = shippedFolder("stock") / (std::string(profile.name) + ".yaml");
    auto read = readRobot(file);
    if (!read) return read.error();
    RobotDescription robot = std::move(read).value();
    const std::string shipped = profile.nameSpace.empty() ? "/" : fmt::format("/{}/", profile.nameSpace);
    for (StreamDescription& stream : robot.streams) {
        if (stream.topic.starts_with(shipped))
            stream.topic = topicIn(nameSpace, stream.topic.substr(shipped.size()));
    }
    for (ServiceDescription& service : robot.services) {
        if (service.name.starts_with(shipped))
            service.name = topicIn(nameSpace, service.name.substr(shipped.size()));
    }
    if (nameSpace.empty()) return robot;
    robot.name = nameSpace;
    std::replace(robot.name.begin(), robot.name.end(), '/', '_');
    // Names that ROS refuses are refused here, too.
    const auto checked = parseRobot(writeRobot(robot), "--namespace");
    return checked ? Result<RobotDescription>(std::move(robot)) : checked.error();
}

}  // namespace leitstand::simulation
