#pragma once

#include "core/base/pose.h"

namespace leitstand::detail {

/// Converts a point of 3DTK (x right, y up, z forward [cm]) to our axes (x forward, y left, z up [m]).
[[nodiscard]] inline Eigen::Vector3d fromUos(const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.z(), -p.x(), p.y()) / 100.0;
}

/// Converts a point in our axes [m] to 3DTK's axes [cm].
[[nodiscard]] inline Eigen::Vector3d toUos(const Eigen::Vector3d& p) {
    return Eigen::Vector3d(-p.y(), p.z(), p.x()) * 100.0;
}

/// Converts the rotation @p inUos of 3DTK to our axes: M R M^-1.
[[nodiscard]] inline Eigen::Matrix3d rotationFromUos(const Eigen::Matrix3d& inUos) {
    const Eigen::Matrix3d m = (Eigen::Matrix3d() << 0, 0, 1, -1, 0, 0, 0, 1, 0).finished();
    return m * inUos * m.transpose();
}

/// Converts the rotation @p ours to 3DTK's axes: M^-1 R M.
[[nodiscard]] inline Eigen::Matrix3d rotationToUos(const Eigen::Matrix3d& ours) {
    const Eigen::Matrix3d m = (Eigen::Matrix3d() << 0, 0, 1, -1, 0, 0, 0, 1, 0).finished();
    return m.transpose() * ours * m;
}

}  // namespace leitstand::detail
