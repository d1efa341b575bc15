#pragma once

#include <span>

#include "core/cloud/scan.h"

namespace leitstand {

/// Returns the points of @p scan that are between @p minRange and @p maxRange from the sensor [m], in the
/// scan's order. Points without an echo are left out. Labels are kept where the scan has them. @p normals:
/// empty, or one a point of the scan.
[[nodiscard]] PointCloud pointsInRange(const Scan& scan, std::span<const Eigen::Vector3f> normals,
                                       double minRange, double maxRange);

}  // namespace leitstand
