#pragma once

#include <cmath>

#include "core/base/pose.h"

namespace leitstand {

/// Heading of the x axis of a frame with @p rotation, seen from above: the yaw (REP 103) [rad].
[[nodiscard]] inline double headingOf(const Eigen::Matrix3d& rotation) {
    return std::atan2(rotation(1, 0), rotation(0, 0));
}
[[nodiscard]] inline double headingOf(const Pose& pose) {
    return headingOf(Eigen::Matrix3d(pose.linear()));
}

}  // namespace leitstand
