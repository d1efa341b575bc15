#include "core/base/pose.h"

#include <algorithm>
#include <cmath>

namespace leitstand {

Pose poseFrom(const Eigen::Vector3d& position, double roll, double pitch, double yaw) {
    Pose pose = Pose::Identity();
    pose.linear() = (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                     Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
                     Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()))
                        .toRotationMatrix();
    pose.translation() = position;
    return pose;
}

double angleBetween(const Pose& a, const Pose& b) {
    // By the quaternion's vector part: exact for small angles, where acos of the trace is not.
    const Eigen::Quaterniond q(a.linear().transpose() * b.linear());
    return 2.0 * std::atan2(q.vec().norm(), std::abs(q.w()));
}

double distanceBetween(const Pose& a, const Pose& b) {
    return (a.translation() - b.translation()).norm();
}

Pose interpolated(const Pose& a, const Pose& b, double share) {
    Pose pose = Pose::Identity();
    pose.translation() = (1.0 - share) * a.translation() + share * b.translation();
    pose.linear() =
        Eigen::Quaterniond(a.linear()).slerp(share, Eigen::Quaterniond(b.linear())).toRotationMatrix();
    return pose;
}

Pose orthonormalised(const Pose& pose) {
    Pose result = pose;
    result.linear() = Eigen::Quaterniond(pose.linear()).normalized().toRotationMatrix();
    return result;
}

Pose poseFromTwist(const Eigen::Matrix<double, 6, 1>& twist) {
    const Eigen::Vector3d rotation = twist.tail<3>();
    const double angle = rotation.norm();
    Pose pose = Pose::Identity();
    if (angle > 0.0) pose.linear() = Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix();
    pose.translation() = twist.head<3>();
    return pose;
}

}  // namespace leitstand
