#pragma once

#include <Eigen/Core>

#include "core/cloud/search/kd_tree_layout.h"

namespace leitstand::detail {

/// Finds a point of @p tree that is nearer to @p query than @p maxSquaredDistance [m^2]. None is nearer than
/// sqrt(@p shrink) times its distance; 1: the nearest (Arya and Mount 1993: shrink = 1 / (1 + epsilon)^2).
using KdNearest = KdFound (*)(const KdStorage& tree, const Eigen::Vector3f& query, float maxSquaredDistance,
                              float shrink);

/// For every processor.
[[nodiscard]] KdFound nearestPlain(const KdStorage& tree, const Eigen::Vector3f& query,
                                   float maxSquaredDistance, float shrink);

#if defined(__x86_64__)
/// For processors with AVX2; finds what nearestPlain() finds.
[[nodiscard]] KdFound nearestAvx2(const KdStorage& tree, const Eigen::Vector3f& query,
                                  float maxSquaredDistance, float shrink);
#endif

}  // namespace leitstand::detail
