#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/cloud/scan.h"

namespace leitstand {

/// The range of heights around a scanner in which walls are seen from above.
struct WallBand {
    double low = -0.6, high = 1.0;  ///< heights relative to the scanner [m]
    double reach = 8.0;             ///< horizontal distance from the scanner [m]
};

/// Returns the points of @p cloud that are on vertical surfaces within @p band, seen from above, relative to
/// the cloud's origin [m]. @p level turns the cloud so that z points up. Empty if the cloud has no normals.
[[nodiscard]] std::vector<Eigen::Vector2f> wallsFromAbove(const PointCloud& cloud,
                                                          const Eigen::Matrix3f& level, const WallBand& band);

/// Returns the first of @p walls in each cell of 15 cm, in their order.
[[nodiscard]] std::vector<Eigen::Vector2f> thinnedWalls(const std::vector<Eigen::Vector2f>& walls);

}  // namespace leitstand
