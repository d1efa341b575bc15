#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/cloud/scan.h"

namespace leitstand {

/// What stands up about a scanner and is seen from above.
struct WallBand {
    double low = -0.6, high = 1.0;  ///< heights over the scanner [m]
    double reach = 8.0;             ///< from the scanner, level [m]
};

/// The points of @p cloud that lie on what stands up within @p band, once they are turned by @p level so that
/// up is up; about the cloud's origin [m]. None where the cloud has no normals.
[[nodiscard]] std::vector<Eigen::Vector2f> wallsFromAbove(const PointCloud& cloud,
                                                          const Eigen::Matrix3f& level, const WallBand& band);

/// One of @p walls in each cell of 15 cm, in their order.
[[nodiscard]] std::vector<Eigen::Vector2f> thinnedWalls(const std::vector<Eigen::Vector2f>& walls);

}  // namespace leitstand
