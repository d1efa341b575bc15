#pragma once

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand {

/// Returns roll, pitch and yaw of @p pose [rad]; poseFrom() makes the same rotation from them. Where x points
/// straight up or down, roll and yaw are not unique: yaw is read off the first column of the matrix, and roll
/// takes up the rest.
[[nodiscard]] Eigen::Vector3d rollPitchYawOf(const Pose& pose);

}  // namespace leitstand
