#include "core/event/all_samples.h"
#include "messages/geometry_msgs.h"
#include "messages/nav_msgs.h"
#include "messages/sensor_msgs.h"
#include "messages/tf2_msgs.h"
#include "transport/convert/detail/conversion.h"

namespace leitstand::detail {
namespace {

using wire::geometry_msgs::Vector3;

/// Checks that the lists beside the names are empty or as long as the names.
void checkLists(std::size_t names, std::size_t positions, std::size_t velocities, std::size_t efforts,
                Checks& checks) {
    checks.require(positions == 0 || positions == names, "position", "expected {} or none, found {}", names,
                   positions);
    checks.require(velocities == 0 || velocities == names, "velocity", "expected {} or none, found {}", names,
                   velocities);
    checks.require(efforts == 0 || efforts == names, "effort", "expected {} or none, found {}", names,
                   efforts);
}

TwistSample twist(const wire::geometry_msgs::Twist& from, Checks& checks) {
    TwistSample to;
    to.linear = checks.vector("linear", from.linear);
    to.angular = checks.vector("angular", from.angular);
    return to;
}

}  // namespace

OdometrySample fromWire(const wire::nav_msgs::Odometry& from, const Source&, Checks& checks) {
    OdometrySample to;
    to.header = checks.header(from.header);
    to.childFrame = from.child_frame_id;
    to.baseInOdom = checks.pose("pose", from.pose.pose);
    to.linear = checks.vector("twist.linear", from.twist.twist.linear);
    to.angular = checks.vector("twist.angular", from.twist.twist.angular);
    to.poseCovariance = covariance(from.pose.covariance);
    to.twistCovariance = covariance(from.twist.covariance);
    return to;
}

void toWire(const OdometrySample& from, wire::nav_msgs::Odometry& to, Buffer&, Checks& checks) {
    to.header = checks.wireHeader(from.header);
    to.child_frame_id = from.childFrame;
    to.pose.pose = checks.wirePose("pose", from.baseInOdom);
    to.twist.twist.linear = checks.wireVector<Vector3>("linear", from.linear);
    to.twist.twist.angular = checks.wireVector<Vector3>("angular", from.angular);
    to.pose.covariance = from.poseCovariance;
    to.twist.covariance = from.twistCovariance;
}

/// A first covariance of -1 means "not measured"; some drivers send a quaternion of zeros instead.
ImuSample fromWire(const wire::sensor_msgs::Imu& from, const Source&, Checks& checks) {
    ImuSample to;
    to.header = checks.header(from.header);
    if (from.orientation_covariance[0] != -1.0 && !Checks::isUnset(from.orientation)) {
        to.orientation = checks.rotation("orientation", from.orientation);
        to.orientationCovariance = covariance(from.orientation_covariance);
    }
    if (from.angular_velocity_covariance[0] != -1.0) {
        to.angularVelocity = checks.vector("angular_velocity", from.angular_velocity);
        to.angularVelocityCovariance = covariance(from.angular_velocity_covariance);
    }
    if (from.linear_acceleration_covariance[0] != -1.0) {
        to.linearAcceleration = checks.vector("linear_acceleration", from.linear_acceleration);
        to.linearAccelerationCovariance = covariance(from.linear_acceleration_covariance);
    }
    return to;
}

void toWire(const ImuSample& from, wire::sensor_msgs::Imu& to, Buffer&, Checks& checks) {
    to.header = checks.wireHeader(from.header);
    to.orientation_covariance = from.orientationCovariance;
    to.angular_velocity_covariance = from.angularVelocityCovariance;
    to.linear_acceleration_covariance = from.linearAccelerationCovariance;
    if (from.orientation) {
        to.orientation = checks.wireRotation("orientation", *from.orientation);
    } else {
        to.orientation.w = 1.0;
        to.orientation_covariance[0] = -1.0;
    }
    if (from.angularVelocity) {
        to.angular_velocity = checks.wireVector<Vector3>("angular_velocity", *from.angularVelocity);
    } else {
        to.angular_velocity_covariance[0] = -1.0;
    }
    if (from.linearAcceleration) {
        to.linear_acceleration = checks.wireVector<Vector3>("linear_acceleration", *from.linearAcceleration);
    } else {
        to.linear_acceleration_covariance[0] = -1.0;
    }
}

/// Values of joints that a driver does not know are NaN.
JointSample fromWire(const wire::sensor_msgs::JointState& from, const Source&, Checks& checks) {
    checkLists(from.name.size(), from.position.size(), from.velocity.size(), from.effort.size(), checks);
    for (const double value : from.position) checks.known("position", value);
    for (const double value : from.velocity) checks.known("velocity", value);
    for (const double value : from.effort) checks.known("effort", value);
    return {checks.header(from.header), from.name, from.position, from.velocity, from.effort};
}

void toWire(const JointSample& from, wire::sensor_msgs::JointState& to, Buffer&, Checks& checks) {
    checkLists(from.names.size(), from.positions.size(), from.velocities.size(), from.efforts.size(), checks);
    for (const double value : from.positions) checks.known("position", value);
    for (const double value : from.velocities) checks.known("velocity", value);
    for (const double value : from.efforts) checks.known("effort", value);
    to = {checks.wireHeader(from.header), from.names, from.positions, from.velocities, from.efforts};
}

TransformsSample fromWire(const wire::tf2_msgs::TFMessage& from, const Source&, Checks& checks) {
    TransformsSample to;
    to.transforms.reserve(from.transforms.size());
    for (const auto& one : from.transforms) {
        checks.require(!one.header.frame_id.empty() && !one.child_frame_id.empty() &&
                           one.header.frame_id != one.child_frame_id,
                       "transforms", "expected two different frames, found \"{}\" in \"{}\"",
                       one.child_frame_id, one.header.frame_id);
        FrameTransform& transform = to.transforms.emplace_back();
        transform.header = checks.header(one.header);
        transform.childFrame = one.child_frame_id;
        transform.childInParent.linear() =
            checks.rotation("transforms.rotation", one.transform.rotation).toRotationMatrix();
        transform.childInParent.translation() =
            checks.vector("transforms.translation", one.transform.translation);
    }
    return to;
}

void toWire(const TransformsSample& from, wire::tf2_msgs::TFMessage& to, Buffer&, Checks& checks) {
    for (const FrameTransform& one : from.transforms) {
        auto& transform = to.transforms.emplace_back();
        transform.header = checks.wireHeader(one.header);
        transform.child_frame_id = one.childFrame;
        transform.transform.translation =
            checks.wireVector<Vector3>("transforms", one.childInParent.translation());
        transform.transform.rotation =
            checks.wireRotation("transforms", Eigen::Quaterniond(one.childInParent.linear()));
    }
}

PoseSample fromWire(const wire::geometry_msgs::PoseStamped& from, const Source&, Checks& checks) {
    PoseSample to;
    to.header = checks.header(from.header);
    to.poseInFrame = checks.pose("pose", from.pose);
    return to;
}

void toWire(const PoseSample& from, wire::geometry_msgs::PoseStamped& to, Buffer&, Checks& checks) {
    to = {checks.wireHeader(from.header), checks.wirePose("pose", from.poseInFrame)};
}

TwistSample fromWire(const wire::geometry_msgs::Twist& from, const Source&, Checks& checks) {
    return twist(from, checks);
}

TwistSample fromWire(const wire::geometry_msgs::TwistStamped& from, const Source&, Checks& checks) {
    TwistSample to = twist(from.twist, checks);
    const SampleHeader header = checks.header(from.header);
    if (header.stamp != Time{}) to.stamp = header.stamp;
    to.frame = header.frame;
    return to;
}

void toWire(const TwistSample& from, wire::geometry_msgs::Twist& to, Buffer&, Checks& checks) {
    to = {checks.wireVector<Vector3>("linear", from.linear),
          checks.wireVector<Vector3>("angular", from.angular)};
}

void toWire(const TwistSample& from, wire::geometry_msgs::TwistStamped& to, Buffer& buffer, Checks& checks) {
    to.header = checks.wireHeader({from.stamp.value_or(Time{}), from.frame});
    toWire(from, to.twist, buffer, checks);
}

std::vector<Conversion> motionConversions() {
    return {
        conversion<wire::nav_msgs::Odometry, OdometrySample>(),
        conversion<wire::sensor_msgs::Imu, ImuSample>(),
        conversion<wire::sensor_msgs::JointState, JointSample>(),
        conversion<wire::tf2_msgs::TFMessage, TransformsSample>(),
        conversion<wire::geometry_msgs::Twist, TwistSample>(),
        conversion<wire::geometry_msgs::TwistStamped, TwistSample>(),
        conversion<wire::geometry_msgs::PoseStamped, PoseSample>(),
    };
}

}  // namespace leitstand::detail
