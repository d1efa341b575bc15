#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/cloud/scan.h"

namespace leitstand {

/// What became of points that were laid into what a scan saw.
struct FreeSpaceFit {
    std::size_t agreed = 0;  ///< they lie where the scan saw something
    std::size_t filled = 0;  ///< they lie where it looked through
    /// Share of those that can be judged, 0 to 1; what is behind something, or where it saw nothing, cannot.
    [[nodiscard]] double filledShare() const;
};

/// How far a scan saw in each direction, from the origin of its frame.
class FreeSpace {
public:
    /// @p points of a scan, in its own frame [m].
    explicit FreeSpace(std::span<const Eigen::Vector3f> points);
    /// @p points in their own frame, which is at @p pose in this scan's.
    [[nodiscard]] FreeSpaceFit fit(std::span<const Eigen::Vector3f> points, const Pose& pose) const;

private:
    struct Cell {
        float nearest = 0.0F, farthest = 0.0F;  ///< [m]; 0: nothing was seen
    };
    [[nodiscard]] static std::size_t cellOf(const Eigen::Vector3f& direction);
    std::vector<Cell> m_cells;  ///< with their neighbours: borders belong to both sides
};

/// The larger share of two scans' points that lie where the other one looked through; @p second is at
/// @p secondInFirst. Where both see the same place it is small; a wall or shelf that only one of them has
/// stands in the other's free space.
[[nodiscard]] double filledShare(const Scan& first, const Scan& second, const Pose& secondInFirst);

}  // namespace leitstand
