#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/perception/surroundings/virtual_scan.h"

namespace leitstand {

struct RangesSample;

/// Returns the end points of the rays of @p turn in odom [m]. Each ray starts from the robot's pose at its
/// time. Rays without an echo or without a known pose are left out. @p sensorInBase: pose of the laser.
[[nodiscard]] std::vector<Eigen::Vector3f> laserPoints(const RangesSample& turn, const Pose& sensorInBase,
                                                       const BaseInOdomAt& baseInOdom);

}  // namespace leitstand
