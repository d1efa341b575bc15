#pragma once

#include <span>

#include "core/cloud/scan.h"

namespace leitstand {

/// Returns the points of @p scan at distances from @p minRange to @p maxRange from the sensor [m], in the
/// scan's order. Points without an echo are left out. Labels are kept if the scan has them. @p normals:
/// empty, or one per point of the scan.
[[nodiscard]] PointCloud pointsInRange(const Scan& scan, std::span<const Eigen::Vector3f> normals,
                                       double minRange, double maxRange);

}  // namespace leitstand
