#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "core/cloud/scan.h"
#include "widgets/map_view/scene/points/point_order.h"

namespace leitstand {

/// Consecutive points of a scan.
struct PointRun {
    std::uint32_t first = 0, end = 0;  ///< indices in ScanPoints::points
};

/// The points of a scan that are in one small part of space.
struct PointCell {
    Eigen::Vector3f centre;            ///< middle of a sphere around them, in the scan's frame [m]
    float radius = 0.0F;               ///< radius of that sphere [m]
    std::uint32_t first = 0, end = 0;  ///< indices in ScanPoints::runs
};

/// The points of a scan that can be drawn. A map has hundreds of scans, so if all points of a scan can be
/// drawn, they share the scan's memory. Otherwise they are a copy.
struct ScanPoints {
    std::shared_ptr<const Scan> owner;        ///< owns the memory of the next two members
    std::span<const Eigen::Vector3f> points;  ///< in the scan's frame [m], all finite
    std::span<const Label> labels;            ///< one per point
    /// Shades of the intensities (shadesOf()), one per point; null: there are no intensities.
    std::shared_ptr<const std::vector<std::uint8_t>> shades;
    /// All points in random order, so that any first part of it is a fair sample.
    std::shared_ptr<const PointOrder> order;
    std::array<std::size_t, LabelCount> labelCounts{};
    std::vector<PointCell> cells;  ///< all points by position, for picking
    /// The points of the cells. A scanner crosses a cell in runs of about a dozen points, so there are far
    /// fewer runs than points.
    std::vector<PointRun> runs;

    /// Returns the point at index @p i of the random order.
    [[nodiscard]] const Eigen::Vector3f& sample(std::size_t i) const { return points[(*order)[i]]; }
    [[nodiscard]] Label labelOfSample(std::size_t i) const { return labels[(*order)[i]]; }
    [[nodiscard]] std::uint8_t shadeOfSample(std::size_t i) const {
        return shades ? (*shades)[(*order)[i]] : std::uint8_t{0};
    }
    /// Returns how much memory it uses in addition to that of @p scan [B].
    [[nodiscard]] std::size_t memory(const Scan& scan) const;
};
using ScanPointsPtr = std::shared_ptr<const ScanPoints>;

/// Returns the finite points of @p scan at distances from @p minRange to @p maxRange from its sensor [m].
/// Their random order is the same at every call. The result keeps @p scan alive if it shares the scan's
/// memory.
[[nodiscard]] ScanPoints drawablePoints(const ScanPtr& scan, double minRange, double maxRange);

}  // namespace leitstand
