#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/cloud/scan.h"

namespace leitstand::detail {

/// Size of an organised scan: rows are raw scans, columns are the points of each.
struct ScanGrid {
    int rows = 0, columns = 0;
};

/// Finds the grid in which a scanner took @p points. In a grid each raw scan covers the same angles in even
/// steps, and the next raw scan begins again at the first angle. Empty for incomplete grids and other clouds.
[[nodiscard]] std::optional<ScanGrid> detectGrid(const std::vector<Eigen::Vector3f>& points);

/// Returns whether the scanner was tilted (about y) or turned (about z) from row to row.
[[nodiscard]] Sweep sweepOf(const std::vector<Eigen::Vector3f>& points, ScanGrid grid);

/// Sets the grid of @p scan and the meaning of its rows, unless the scan has a grid already. Leaves clouds
/// without a grid as they are.
void organise(Scan& scan);

}  // namespace leitstand::detail
