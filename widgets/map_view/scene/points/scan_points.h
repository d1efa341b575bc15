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

/// Points of a scan that follow each other in its list.
struct PointRun {
    std::uint32_t first = 0, end = 0;  ///< in ScanPoints::points
};

/// The points of a scan in one small part of space.
struct PointCell {
    Eigen::Vector3f centre;            ///< of a ball around them, in the scan's frame [m]
    float radius = 0.0F;               ///< [m]
    std::uint32_t first = 0, end = 0;  ///< in ScanPoints::runs
};

/// The points of a scan that can be drawn. A map has hundreds of scans: where all of a scan's points can be
/// drawn, they are the scan's own memory, else a copy of those that can.
struct ScanPoints {
    std::shared_ptr<const Scan> owner;        ///< of the memory behind the next two
    std::span<const Eigen::Vector3f> points;  ///< in the scan's frame [m], all of them finite
    std::span<const Label> labels;            ///< one per point
    /// One per point, of their intensities (shadesOf()); null: nobody told them.
    std::shared_ptr<const std::vector<std::uint8_t>> shades;
    /// All points once, at random: every beginning of the list is a fair sample.
    std::shared_ptr<const PointOrder> order;
    std::array<std::size_t, LabelCount> labelCounts{};
    std::vector<PointCell> cells;  ///< all points by place, for picking
    /// The cells' points. A scanner passes through a cell in runs of a dozen: these are a fraction of the
    /// points.
    std::vector<PointRun> runs;

    /// The @p i-th point at random.
    [[nodiscard]] const Eigen::Vector3f& sample(std::size_t i) const { return points[(*order)[i]]; }
    [[nodiscard]] Label labelOfSample(std::size_t i) const { return labels[(*order)[i]]; }
    [[nodiscard]] std::uint8_t shadeOfSample(std::size_t i) const {
        return shades ? (*shades)[(*order)[i]] : std::uint8_t{0};
    }
    /// Bytes that it takes beside the scan's own.
    [[nodiscard]] std::size_t memory(const Scan& scan) const;
};
using ScanPointsPtr = std::shared_ptr<const ScanPoints>;

/// The finite points of @p scan between @p minRange and @p maxRange from its sensor [m]; the same order for
/// the same scan. Holds @p scan where it shares its points.
[[nodiscard]] ScanPoints drawablePoints(const ScanPtr& scan, double minRange, double maxRange);

}  // namespace leitstand
