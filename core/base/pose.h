#pragma once

#include <Eigen/Geometry>

namespace leitstand {

/// Position and attitude of a frame in another one, named aInB (REP 103: right-handed, x forward, y left,
/// z up) [m].
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

/// Angle by which two poses differ [rad], between 0 and pi.
[[nodiscard]] double angleBetween(const Pose& a, const Pose& b);

/// Distance of the origins of two poses [m].
[[nodiscard]] double distanceBetween(const Pose& a, const Pose& b);

/// The pose at @p share (0 to 1) of the way from @p a to @p b: straight line, shortest turn.
[[nodiscard]] Pose interpolated(const Pose& a, const Pose& b, double share);

/// Returns @p pose with numerical drift removed from its rotation.
[[nodiscard]] Pose orthonormalised(const Pose& pose);

/// Returns the motion of a twist: translation first [m], then the rotation vector [rad]. Approximates
/// exp([v, w]): translation is taken as it is (the Jacobian is neglected), rotation by Rodrigues' formula.
[[nodiscard]] Pose poseFromTwist(const Eigen::Matrix<double, 6, 1>& translationThenRotation);

}  // namespace leitstand
