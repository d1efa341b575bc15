#include "core/base/rotation/euler_angles.h"

#include <cmath>

namespace leitstand {

Eigen::Vector3d rollPitchYawOf(const Pose& pose) {
    const Eigen::Matrix3d r = pose.linear();
    const double yaw = std::atan2(r(1, 0), r(0, 0)), c = std::cos(yaw), s = std::sin(yaw);
    // From the rotation without yaw: its digits do not depend on those of a cosine that is nearly 0.
    const double roll = std::atan2(s * r(0, 2) - c * r(1, 2), c * r(1, 1) - s * r(0, 1));
    return {roll, std::atan2(-r(2, 0), c * r(0, 0) + s * r(1, 0)), yaw};
}

}  // namespace leitstand
