#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "core/base/pose.h"
#include "core/event/sample_header.h"

namespace leitstand {

/// Where a robot believes to be by its wheels or tracks (nav_msgs/msg/Odometry).
struct OdometrySample {
    SampleHeader header;                                ///< frame: of the odometry, "kurt3d/odom"
    std::string childFrame;                             ///< "kurt3d/base_link"
    Pose baseInOdom = Pose::Identity();                 ///< child frame in header's frame
    Eigen::Vector3d linear = Eigen::Vector3d::Zero();   ///< velocity, in the child frame [m/s]
    Eigen::Vector3d angular = Eigen::Vector3d::Zero();  ///< velocity, in the child frame [rad/s]
    std::array<double, 36> poseCovariance{};            ///< x y z roll pitch yaw, row-major; 0: unknown
    std::array<double, 36> twistCovariance{};           ///< likewise
};

/// What an inertial unit measured (sensor_msgs/msg/Imu); what it does not measure is empty.
struct ImuSample {
    SampleHeader header;
    std::optional<Eigen::Quaterniond> orientation;      ///< unit length, of the header's frame in a level one
    std::optional<Eigen::Vector3d> angularVelocity;     ///< [rad/s]
    std::optional<Eigen::Vector3d> linearAcceleration;  ///< with gravity: +9.81 upwards at rest [m/s2]
    std::array<double, 9> orientationCovariance{};      ///< row-major; 0: unknown
    std::array<double, 9> angularVelocityCovariance{};
    std::array<double, 9> linearAccelerationCovariance{};
};

/// Joints, or what is asked of them: joint_states, track_cmd and ptu_cmd (sensor_msgs/msg/JointState).
struct JointSample {
    SampleHeader header;
    std::vector<std::string> names;
    std::vector<double> positions;   ///< empty, or one a name [rad, m]
    std::vector<double> velocities;  ///< empty, or one a name [rad/s, m/s]
    std::vector<double> efforts;     ///< empty, or one a name [Nm, N]
};
using TrackCommand = JointSample;    ///< velocities of the tracks
using PanTiltCommand = JointSample;  ///< positions of left_pan, left_tilt, right_pan, right_tilt

/// Where one frame sits in another.
struct FrameTransform {
    SampleHeader header;  ///< frame: the parent
    std::string childFrame;
    Pose childInParent = Pose::Identity();
};

/// What tf and tf_static say (tf2_msgs/msg/TFMessage).
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
    std::optional<Time> stamp;                          ///< of TwistStamped; empty: none, sent as zero
    std::string frame;                                  ///< of TwistStamped; may be empty
    Eigen::Vector3d linear = Eigen::Vector3d::Zero();   ///< in the robot's base frame [m/s]
    Eigen::Vector3d angular = Eigen::Vector3d::Zero();  ///< [rad/s]
};

}  // namespace leitstand
