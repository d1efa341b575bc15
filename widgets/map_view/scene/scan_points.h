#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Geometry>

#include "core/scan/scan.h"

namespace leitstand {

/// The points of a scan in one small part of space.
struct PointCell {
    Eigen::Vector3f centre;          ///< of a ball around them, in the scan's frame [m]
    float radius = 0.0F;             ///< [m]
    std::size_t first = 0, end = 0;  ///< in ScanPoints::cellMembers
};

/// The points of a scan that can be drawn, in random order: every beginning of the list is a fair sample.
struct ScanPoints {
    std::vector<Eigen::Vector3f> points;  ///< in the scan's frame [m]
    std::vector<Label> labels;            ///< one per point
    std::array<std::size_t, LabelCount> labelCounts{};
    std::vector<PointCell> cells;            ///< all points by place, for picking
    std::vector<std::uint32_t> cellMembers;  ///< the cells' points
};
using ScanPointsPtr = std::shared_ptr<const ScanPoints>;

/// The finite points of @p scan between @p minRange and @p maxRange from its sensor [m]; the same order for
/// the same scan.
[[nodiscard]] ScanPoints drawablePoints(const Scan& scan, double minRange, double maxRange);

}  // namespace leitstand
