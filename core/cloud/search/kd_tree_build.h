#pragma once

#include <span>

#include <Eigen/Core>

#include "core/cloud/search/kd_tree_layout.h"

namespace leitstand::detail {

/// Builds the tree over @p points, or over those with the indices @p chosen. Points that are not finite are
/// left out. Boxes are split at the centroid, across their longest side. Throws std::length_error for more
/// than 2^31 - 1 points.
[[nodiscard]] KdStorage buildKdTree(std::span<const Eigen::Vector3f> points);
[[nodiscard]] KdStorage buildKdTree(std::span<const Eigen::Vector3f> points,
                                    std::span<const std::int32_t> chosen);

}  // namespace leitstand::detail
