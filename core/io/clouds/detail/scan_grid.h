#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/cloud/scan.h"

namespace leitstand::detail {

/// Rows (raw scans) and columns (points in each) of an organised scan.
struct ScanGrid {
    int rows = 0, columns = 0;
};

/// Finds the grid in which a scanner took @p points: every raw scan covers the same angles in even steps, and
/// the next one starts over. Empty for incomplete grids and other clouds.
[[nodiscard]] std::optional<ScanGrid> detectGrid(const std::vector<Eigen::Vector3f>& points);

/// Whether the rows are tilted (about y) or turned (about z) against each other.
[[nodiscard]] Sweep sweepOf(const std::vector<Eigen::Vector3f>& points, ScanGrid grid);

/// Sets the grid of @p scan, unless it has one already, and the meaning of its rows. Leaves clouds without a
/// grid as they are.
void organise(Scan& scan);

}  // namespace leitstand::detail
