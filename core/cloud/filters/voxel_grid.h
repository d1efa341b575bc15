#pragma once

#include <cstdint>

#include "core/cloud/scan.h"

namespace leitstand {

/// Which point stands for a voxel.
enum class VoxelPoint : std::uint8_t {
    Nearest,   ///< the real point nearest to the centroid, with its label and normal
    Centroid,  ///< the centroid, with the commonest label and the mean normal
};

/// One point for each cube of edge @p edge [m] that holds any, in the order in which the cubes are met; the
/// grid begins at the frame's origin. Points that are not finite, or farther than 2^20 edges from the origin
/// along an axis, are left out. Weights are not carried over: all voxels count alike. Throws
/// std::invalid_argument unless @p edge is above 0.
[[nodiscard]] PointCloud voxelGrid(const PointCloud& cloud, double edge,
                                   VoxelPoint kept = VoxelPoint::Nearest);

}  // namespace leitstand
