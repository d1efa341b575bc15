#pragma once

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand {

/// Roll, pitch and yaw of @p pose [rad], from which poseFrom() makes its rotation again, also where it looks
/// straight up or down: there yaw is whatever the rotation has it, and roll takes up the rest.
[[nodiscard]] Eigen::Vector3d rollPitchYawOf(const Pose& pose);

}  // namespace leitstand
