#include "core/mapping/graph/link_error.h"

#include <Eigen/Geometry>

namespace leitstand {
namespace {

Eigen::Matrix3d cross(const Eigen::Vector3d& v) {
    Eigen::Matrix3d matrix;
    matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return matrix;
}

Eigen::Quaterniond upperHalf(const Eigen::Matrix3d& rotation) {
    Eigen::Quaterniond q(rotation);
    if (q.w() < 0.0) q.coeffs() = -q.coeffs();
    return q;
}

LinkVector errorOf(const Eigen::Vector3d& translation, const Eigen::Quaterniond& q) {
    LinkVector error;
    error << translation, 2.0 * q.vec();
    return error;
}

}  // namespace

LinkVector linkError(const Pose& from, const Pose& to, const Pose& link) {
    const Eigen::Matrix3d fromBack = from.linear().transpose(), linkBack = link.linear().transpose();
    const Eigen::Vector3d moved = fromBack * (to.translation() - from.translation());
    return errorOf(linkBack * (moved - link.translation()), upperHalf(linkBack * fromBack * to.linear()));
}

LinearLink linearLink(const Pose& from, const Pose& to, const Pose& link) {
    const Eigen::Matrix3d fromBack = from.linear().transpose(), linkBack = link.linear().transpose();
    const Eigen::Vector3d moved = fromBack * (to.translation() - from.translation());
    const Eigen::Matrix3d turned = fromBack * to.linear(), rest = linkBack * turned;
    const Eigen::Quaterniond q = upperHalf(rest);
    LinearLink result;
    result.error = errorOf(linkBack * (moved - link.translation()), q);
    const Eigen::Matrix3d turn = q.w() * Eigen::Matrix3d::Identity() + cross(q.vec());
    result.byTo.setZero();
    result.byTo.topLeftCorner<3, 3>() = rest;
    result.byTo.bottomRightCorner<3, 3>() = turn;
    result.byFrom.setZero();
    result.byFrom.topLeftCorner<3, 3>() = -linkBack;
    result.byFrom.topRightCorner<3, 3>() = linkBack * cross(moved);
    result.byFrom.bottomRightCorner<3, 3>() = -turn * turned.transpose();
    return result;
}

Pose movedBy(const Pose& pose, const LinkVector& step) {
    Pose moved = pose;
    moved.translation() += pose.linear() * step.head<3>();
    const Eigen::Vector3d turn = step.tail<3>();
    const double angle = turn.norm();
    if (angle > 0.0) {
        const Eigen::Quaterniond q(Eigen::AngleAxisd(angle, turn / angle));
        moved.linear() = (Eigen::Quaterniond(pose.linear()) * q).normalized().toRotationMatrix();
    }
    return moved;
}

}  // namespace leitstand
