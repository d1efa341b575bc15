#pragma once

#include <cstdint>
#include <span>

#include "core/cloud/scan.h"

namespace leitstand {

/// Which point represents a voxel.
enum class VoxelPoint : std::uint8_t {
    Nearest,   ///< the real point nearest to the centroid, with its label and normal
    Centroid,  ///< the centroid, with the most common label and the mean normal
};

/// Returns one point for each occupied cube of a grid, in the order in which the cloud first meets the cubes.
/// Cubes have edges of @p edge [m]; the grid begins at @p origin. Points that are not finite, or farther than
/// 2^20 edges from the origin along an axis, are left out. Weights are not kept: all voxels have the same
/// weight. Throws std::invalid_argument unless @p edge is above 0.
[[nodiscard]] PointCloud voxelGrid(const PointCloud& cloud, double edge,
                                   VoxelPoint kept = VoxelPoint::Nearest,
                                   const Eigen::Vector3d& origin = Eigen::Vector3d::Zero());

/// Returns a grid origin that differs from scan to scan, within a cube with edges of @p edge [m]. It looks
/// random, but is always the same for the same @p points. If all grids began at the sensor, they would move
/// with it, and registration would pull scans together so that their grids coincide. With grids of 10 cm,
/// steps of 36 cm would be measured as 36.1 cm.
[[nodiscard]] Eigen::Vector3d ownGridOrigin(std::span<const Eigen::Vector3f> points, double edge);

}  // namespace leitstand
