#pragma once

#include "core/base/pose.h"

namespace leitstand {

/// Where a goal of the map lies in the odometry's frame of a robot that is at @p baseInMap and, by its
/// odometry at the same moment, at @p baseInOdom. Level: robots drive on the ground, and odometry may know no
/// tilt.
[[nodiscard]] Pose goalInOdom(const Pose& baseInMap, const Pose& baseInOdom, const Pose& goalInMap);

}  // namespace leitstand
