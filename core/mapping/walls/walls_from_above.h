#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/cloud/scan.h"

namespace leitstand {

/// The band of heights around a scanner whose walls are seen from above.
struct WallBand {
    double low = -0.6, high = 1.0;  ///< heights over the scanner [m]
    double reach = 8.0;             ///< level distance from the scanner [m]
};

/// Returns the points of @p cloud on upright surfaces within @p band, after @p level has turned them so that
/// z points up; relative to the cloud's origin [m]. Empty if the cloud has no normals.
[[nodiscard]] std::vector<Eigen::Vector2f> wallsFromAbove(const PointCloud& cloud,
                                                          const Eigen::Matrix3f& level, const WallBand& band);

/// Returns one of @p walls in each cell of 15 cm, in their order.
[[nodiscard]] std::vector<Eigen::Vector2f> thinnedWalls(const std::vector<Eigen::Vector2f>& walls);

}  // namespace leitstand
