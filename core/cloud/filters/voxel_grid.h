#pragma once

#include <cstdint>
#include <span>

#include "core/cloud/scan.h"

namespace leitstand {

/// Which point represents a voxel.
enum class VoxelPoint : std::uint8_t {
    Nearest,   ///< the real point nearest to the centroid, with its label and normal
    Centroid,  ///< the centroid, with the commonest label and the mean normal
};

/// Returns one point for each cube of edge @p edge [m] that holds any, in the order in which the cubes are
/// met. The grid begins at @p origin. Points that are not finite, or farther than 2^20 edges from the origin
/// along an axis, are left out. Weights are not carried over: all voxels count alike. Throws
/// std::invalid_argument unless @p edge is above 0.
[[nodiscard]] PointCloud voxelGrid(const PointCloud& cloud, double edge,
                                   VoxelPoint kept = VoxelPoint::Nearest,
                                   const Eigen::Vector3d& origin = Eigen::Vector3d::Zero());

/// Returns a grid origin of the scan's own, within a cube of edge @p edge [m]. It looks drawn at random, and
/// is always the same for the same @p points. Grids that all begin at the sensor move along with it, and
/// registration pulls two scans to where their grids meet. With grids of 10 cm, robots that went 36 cm are
/// put 36.1 cm ahead.
[[nodiscard]] Eigen::Vector3d ownGridOrigin(std::span<const Eigen::Vector3f> points, double edge);

}  // namespace leitstand
