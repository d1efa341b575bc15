#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/cloud/scan.h"

namespace leitstand {

/// How points at a pose fit the space that a scan saw.
struct FreeSpaceFit {
    std::size_t agreed = 0;  ///< points where the scan saw something
    std::size_t filled = 0;  ///< points where the scan looked through
    /// Returns the filled share of the points that can be judged, 0 to 1. Points behind something, or where
    /// nothing was seen, cannot.
    [[nodiscard]] double filledShare() const;
};

/// What a scan shows at a place.
enum class SeenThere : std::uint8_t {
    Unknown,  ///< behind something, or nothing was seen there, or near and far at once
    Surface,  ///< something is about there
    LookedThrough,
};

/// How carefully a scan decides that it looked through a place.
struct FreeSpaceSettings {
    /// A place is free space if what was seen in its direction is farther by more than both of these. They
    /// allow for noise, and for motion within the turn.
    float margin = 0.3F;          ///< [m] ...
    float marginOfRange = 0.05F;  ///< ... and share of the range
    /// Least range [m]: nearer, a cell is smaller than the robot's motion in a turn.
    float nearest = 1.0F;
    /// Whether what was seen in all neighbouring cells (2 degrees) counts, too; else only in those across a
    /// near border of the cell.
    bool beside = true;
    std::uint32_t rays = 1;  ///< least number of rays in a cell for at() to decide: between few there is room
};

/// How far a scan saw in each direction, from the origin of its frame.
class FreeSpace {
public:
    /// @p points of a scan, in its own frame [m].
    explicit FreeSpace(std::span<const Eigen::Vector3f> points, const FreeSpaceSettings& settings = {});
    /// Returns how @p points fit the space that this scan saw. @p pose: pose of the points' frame in this
    /// scan's frame.
    [[nodiscard]] FreeSpaceFit fit(std::span<const Eigen::Vector3f> points, const Pose& pose) const;
    /// Returns what the scan shows at @p place, in this scan's frame [m].
    [[nodiscard]] SeenThere at(const Eigen::Vector3f& place) const;

private:
    struct Cell {
        float nearest = 0.0F, farthest = 0.0F;  ///< [m]; 0: nothing was seen
        std::uint32_t rays = 0;                 ///< in this cell alone
    };
    [[nodiscard]] static std::size_t cellOf(const Eigen::Vector3f& direction);
    FreeSpaceSettings m_settings;
    std::vector<Cell> m_cells;  ///< each with its neighbours if `beside` is set: borders belong to both sides
};

/// Returns the share of a scan's points that lie where the other scan looked through; of both scans, the
/// larger share. @p secondInFirst: pose of @p second in the frame of @p first. The share is small if both see
/// the same place. A wall or shelf that only one of them shows stands in the other's free space.
[[nodiscard]] double filledShare(const Scan& first, const Scan& second, const Pose& secondInFirst);

}  // namespace leitstand
