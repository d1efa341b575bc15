#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/event/cloud_sample.h"
#include "core/perception/surroundings/virtual_scan.h"

namespace leitstand {

/// Where the rays of @p turn ended, in odom [m], each from where the robot was then; rays without an echo,
/// and those of which nobody knows where the robot was, are left out. @p sensorInBase: the laser.
[[nodiscard]] std::vector<Eigen::Vector3f> laserPoints(const RangesSample& turn, const Pose& sensorInBase,
                                                       const BaseInOdomAt& baseInOdom);

}  // namespace leitstand
