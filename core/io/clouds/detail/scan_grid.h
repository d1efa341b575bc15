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

/// The grid in which a scanner took @p points, if they lie in one: every raw scan goes through the same
/// angles in even steps and the next one starts over. Nothing for incomplete grids and other clouds.
[[nodiscard]] std::optional<ScanGrid> detectGrid(const std::vector<Eigen::Vector3f>& points);

/// Whether the rows are tilted (about y) or turned (about z) against each other.
[[nodiscard]] Sweep sweepOf(const std::vector<Eigen::Vector3f>& points, ScanGrid grid);

/// Gives @p scan the grid that its points lie in, unless it has one already, and the meaning of its rows.
void organise(Scan& scan);

}  // namespace leitstand::detail
