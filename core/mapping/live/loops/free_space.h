#pragma once

#include <cstddef>
#include <cstdint>
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

/// What a scan says of a place.
enum class SeenThere : std::uint8_t {
    Unknown,  ///< it is behind something, or it saw nothing there, or near and far at once
    Surface,  ///< something is about there
    LookedThrough,
};

/// How carefully a scan says that it looked through a place.
struct FreeSpaceSettings {
    /// So far before what was seen there a place is in free space: noise, a robot that moved within the turn.
    float margin = 0.3F;          ///< [m] ...
    float marginOfRange = 0.05F;  ///< ... and of the range
    float nearest =
        1.0F;  ///< nearer to the scanner a cell is smaller than what the robot moved in a turn [m]
    /// Whether what was seen 2 degrees beside counts, too; else only what lies so near to a cell's border.
    bool beside = true;
    std::uint32_t rays = 1;  ///< so many at least went where at() says anything: between few there is room
};

/// How far a scan saw in each direction, from the origin of its frame.
class FreeSpace {
public:
    /// @p points of a scan, in its own frame [m].
    explicit FreeSpace(std::span<const Eigen::Vector3f> points, const FreeSpaceSettings& settings = {});
    /// @p points in their own frame, which is at @p pose in this scan's.
    [[nodiscard]] FreeSpaceFit fit(std::span<const Eigen::Vector3f> points, const Pose& pose) const;
    /// Of one place, in this scan's frame [m].
    [[nodiscard]] SeenThere at(const Eigen::Vector3f& place) const;

private:
    struct Cell {
        float nearest = 0.0F, farthest = 0.0F;  ///< [m]; 0: nothing was seen
        std::uint32_t rays = 0;                 ///< there alone
    };
    [[nodiscard]] static std::size_t cellOf(const Eigen::Vector3f& direction);
    FreeSpaceSettings m_settings;
    std::vector<Cell> m_cells;  ///< with their neighbours where that is set: borders belong to both sides
};

/// The larger share of two scans' points that lie where the other one looked through; @p second is at
/// @p secondInFirst. Where both see the same place it is small; a wall or shelf that only one of them has
/// stands in the other's free space.
[[nodiscard]] double filledShare(const Scan& first, const Scan& second, const Pose& secondInFirst);

}  // namespace leitstand
