#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "core/base/pose.h"
#include "core/event/sample_header.h"

namespace leitstand {

/// Pose and velocity of a robot from its wheels or tracks (nav_msgs/msg/Odometry).
struct OdometrySample {
    SampleHeader header;                                ///< its frame is that of the odometry, "kurt3d/odom"
    std::string childFrame;                             ///< "kurt3d/base_link"
    Pose baseInOdom = Pose::Identity();                 ///< pose of the child frame in the header's frame
    Eigen::Vector3d linear = Eigen::Vector3d::Zero();   ///< velocity, in the child frame [m/s]
    Eigen::Vector3d angular = Eigen::Vector3d::Zero();  ///< velocity, in the child frame [rad/s]
    std::array<double, 36> poseCovariance{};            ///< for x y z roll pitch yaw, row by row; 0: unknown
    std::array<double, 36> twistCovariance{};           ///< for x y z roll pitch yaw, row by row; 0: unknown
};

/// Measurements of an inertial unit (sensor_msgs/msg/Imu). What it does not measure is empty.
struct ImuSample {
    SampleHeader header;
    /// Of unit length: rotation of the header's frame in a level frame.
    std::optional<Eigen::Quaterniond> orientation;
    std::optional<Eigen::Vector3d> angularVelocity;     ///< [rad/s]
    std::optional<Eigen::Vector3d> linearAcceleration;  ///< including gravity: +9.81 upwards at rest [m/s2]
    std::array<double, 9> orientationCovariance{};      ///< row by row; 0: unknown
    std::array<double, 9> angularVelocityCovariance{};
    std::array<double, 9> linearAccelerationCovariance{};
};

/// Joints, or commands to them: joint_states, track_cmd and ptu_cmd (sensor_msgs/msg/JointState).
struct JointSample {
    SampleHeader header;
    std::vector<std::string> names;
    std::vector<double> positions;   ///< empty, or one per name [rad, m]
    std::vector<double> velocities;  ///< empty, or one per name [rad/s, m/s]
    std::vector<double> efforts;     ///< empty, or one per name [Nm, N]
};
using TrackCommand = JointSample;    ///< velocities of the tracks
using PanTiltCommand = JointSample;  ///< positions of left_pan, left_tilt, right_pan, right_tilt

/// Where joints are at one moment of a trajectory.
struct TrajectoryPoint {
    std::vector<double> positions;   ///< empty, or one per name [rad, m]
    std::vector<double> velocities;  ///< empty, or one per name [rad/s, m/s]
    std::chrono::nanoseconds fromStart{};
};

/// Asks joints to follow a trajectory (trajectory_msgs/msg/JointTrajectory). Accelerations and efforts, which
/// only come from others, are dropped.
struct JointTrajectorySample {
    static constexpr std::size_t MostPoints = 100'000;

    SampleHeader header;  ///< a stamp of zero: from now on
    std::vector<std::string> names;
    std::vector<TrajectoryPoint> points;
};

/// Numbers that mean something to their receiver: setpoints of joints in its own order
/// (std_msgs/msg/Float64MultiArray, without its layout).
struct NumbersSample {
    std::vector<double> values;
};

/// Pose of one frame in another.
struct FrameTransform {
    SampleHeader header;  ///< its frame is the parent
    std::string childFrame;
    Pose childInParent = Pose::Identity();
};

/// Content of tf and tf_static (tf2_msgs/msg/TFMessage).
struct TransformsSample {
    std::vector<FrameTransform> transforms;
};

/// A pose in a frame: a goal to drive to (geometry_msgs/msg/PoseStamped).
struct PoseSample {
    SampleHeader header;
    Pose poseInFrame = Pose::Identity();
};

/// A drive command (geometry_msgs/msg/Twist or TwistStamped).
struct TwistSample {
    std::optional<Time> stamp;  ///< for TwistStamped; empty: its stamp is zero, or the command is a Twist
    std::string frame;          ///< for TwistStamped; may be empty
    Eigen::Vector3d linear = Eigen::Vector3d::Zero();   ///< in the robot's base frame [m/s]
    Eigen::Vector3d angular = Eigen::Vector3d::Zero();  ///< [rad/s]
};

/// The way that a robot plans to take (nav_msgs/msg/Path).
struct PathSample {
    static constexpr std::size_t MostPoses = 100'000;

    SampleHeader header;
    std::vector<Pose> posesInFrame;  ///< from its beginning to its end; empty: no way was found
};

}  // namespace leitstand
