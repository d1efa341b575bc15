#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/cloud/scan.h"

namespace leitstand {

/// How points fit the space that a scan saw, if they are placed at some pose.
struct FreeSpaceFit {
    std::size_t agreed = 0;  ///< number of points where the scan saw something
    std::size_t filled = 0;  ///< number of points where the scan saw free space
    /// Returns the share of `filled` in the points that can be judged, 0 to 1. Points behind something, or
    /// where nothing was seen, cannot be judged.
    [[nodiscard]] double filledShare() const;
};

/// What a scan shows about a place.
enum class SeenThere : std::uint8_t {
    Unknown,  ///< it is behind something, nothing was seen there, or both near and far was seen
    Surface,  ///< something is near the place
    LookedThrough,
};

/// How carefully a scan decides that a place is free space.
struct FreeSpaceSettings {
    /// A place is free space if the range seen in its direction is larger by more than `margin` and
    /// `marginOfRange`. These allow for noise, and for motion during the turn.
    float margin = 0.3F;          ///< fixed margin [m]
    float marginOfRange = 0.05F;  ///< margin as a share of the range
    /// Least range at which space can be free [m]. Nearer, a cell is smaller than the robot's motion during a
    /// turn.
    float nearest = 1.0F;
    /// Whether ranges of all neighbouring cells (2 degrees) are used, too. Otherwise only those beyond a
    /// border of the cell that is close.
    bool beside = true;
    /// Least number of rays in a cell for at() to decide, because of gaps between few rays.
    std::uint32_t rays = 1;
};

/// How far a scan saw in each direction, from the origin of its frame.
class FreeSpace {
public:
    /// @p points: those of the scan, in its own frame [m].
    explicit FreeSpace(std::span<const Eigen::Vector3f> points, const FreeSpaceSettings& settings = {});
    /// Returns how @p points fit the space that this scan saw. @p pose: pose of their frame in this scan's
    /// frame.
    [[nodiscard]] FreeSpaceFit fit(std::span<const Eigen::Vector3f> points, const Pose& pose) const;
    /// Returns what the scan shows about @p place, which is in the scan's frame [m].
    [[nodiscard]] SeenThere at(const Eigen::Vector3f& place) const;

private:
    struct Cell {
        /// Least and largest range seen in the cell [m]; 0: nothing was seen.
        float nearest = 0.0F, farthest = 0.0F;
        std::uint32_t rays = 0;  ///< number of rays in this cell, without neighbours
    };
    [[nodiscard]] static std::size_t cellOf(const Eigen::Vector3f& direction);
    FreeSpaceSettings m_settings;
    /// If `beside` is set, a cell includes its neighbours: borders belong to both sides.
    std::vector<Cell> m_cells;
};

/// Returns the share of a scan's points that lie where the other scan saw free space. This is computed for
/// both scans, and the larger share is returned. @p secondInFirst: pose of @p second in the frame of
/// @p first. The share is small if both see the same place. A wall or shelf that only one of them shows
/// stands in the other's free space.
[[nodiscard]] double filledShare(const Scan& first, const Scan& second, const Pose& secondInFirst);

}  // namespace leitstand
