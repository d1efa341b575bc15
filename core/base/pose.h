#pragma once

#include <Eigen/Geometry>

namespace leitstand {

/// Position [m] and attitude of a frame in another frame (REP 103: right-handed, x forward, y left, z up). A
/// variable named aInB has the pose of a in b.
using Pose = Eigen::Isometry3d;

/// @p value degrees in radians.
constexpr double degrees(double value) {
    return value * 3.14159265358979323846 / 180.0;
}

/// @p radians in degrees.
constexpr double inDegrees(double radians) {
    return radians * 180.0 / 3.14159265358979323846;
}

/// A pose from a position [m] and roll, pitch, yaw [rad] (R = Rz(yaw) Ry(pitch) Rx(roll), REP 103).
[[nodiscard]] Pose poseFrom(const Eigen::Vector3d& position, double roll, double pitch, double yaw);

/// Angle between the attitudes of two poses [rad], from 0 to pi.
[[nodiscard]] double angleBetween(const Pose& a, const Pose& b);

/// Distance between the origins of two poses [m].
[[nodiscard]] double distanceBetween(const Pose& a, const Pose& b);

/// The pose after @p share (0 to 1) of the way from @p a to @p b: in a straight line, with the shortest turn.
[[nodiscard]] Pose interpolated(const Pose& a, const Pose& b, double share);

/// Returns @p pose with numerical drift removed from its rotation.
[[nodiscard]] Pose orthonormalised(const Pose& pose);

/// Returns the motion of a twist: translation [m], then the rotation vector [rad]. It approximates exp([v,
/// w]): the translation is used as it is (neglecting the Jacobian), the rotation follows Rodrigues' formula.
[[nodiscard]] Pose poseFromTwist(const Eigen::Matrix<double, 6, 1>& translationThenRotation);

}  // namespace leitstand
