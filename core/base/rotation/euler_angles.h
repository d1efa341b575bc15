#pragma once

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand {

/// Returns roll, pitch and yaw of @p pose [rad]; poseFrom() makes the same rotation from them. Where the pose
/// looks straight up or down, yaw is what the matrix gives, and roll takes up the rest.
[[nodiscard]] Eigen::Vector3d rollPitchYawOf(const Pose& pose);

}  // namespace leitstand
