#pragma once

#include <Eigen/Core>

#include "core/cloud/search/kd_tree_layout.h"

namespace leitstand::detail {

/// Finds a point of @p tree whose squared distance from @p query is below @p maxSquaredDistance [m^2]. No
/// other point is nearer than sqrt(@p shrink) times the distance of the found point. A shrink of 1 finds the
/// nearest point; 1 / (1 + epsilon)^2 gives the approximate search of Arya and Mount 1993.
using KdNearest = KdFound (*)(const KdStorage& tree, const Eigen::Vector3f& query, float maxSquaredDistance,
                              float shrink);

/// For every processor.
[[nodiscard]] KdFound nearestPlain(const KdStorage& tree, const Eigen::Vector3f& query,
                                   float maxSquaredDistance, float shrink);

#if defined(__x86_64__)
/// For processors with AVX2; finds the same as nearestPlain().
[[nodiscard]] KdFound nearestAvx2(const KdStorage& tree, const Eigen::Vector3f& query,
                                  float maxSquaredDistance, float shrink);
#endif

}  // namespace leitstand::detail
