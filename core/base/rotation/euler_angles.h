#pragma once

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand {

/// Returns roll, pitch and yaw of @p pose [rad], from which poseFrom() makes the same rotation. If x points
/// straight up or down, roll and yaw are not unique. Then yaw is taken from the first column of the matrix,
/// and roll is the rest.
[[nodiscard]] Eigen::Vector3d rollPitchYawOf(const Pose& pose);

}  // namespace leitstand
