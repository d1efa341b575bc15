#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/handin/map/voxel_evidence.h"
#include "core/mapping/floor_heights.h"

namespace leitstand {

/// A range of heights above the local floor that a flat map shows [m].
struct HeightBand {
    double low = 0.25, high = 0.35;
};
/// Returns the two height bands of the hand-in. The first shows what stops a driving robot. The second shows
/// what still stands at a height of a metre, without the steps, boxes and barriers that hide the rooms.
[[nodiscard]] const std::vector<HeightBand>& reportBands();
/// Returns the bands in which @p scans show anything: reportBands(), or one about the heights above @p floor
/// at which plane lasers saw, when all scans are of such.
[[nodiscard]] std::vector<HeightBand> bandsOf(std::span<const ReportScan> scans, const FloorHeights& floor);

/// A map seen from above.
struct OccupancyGrid {
    enum class State : std::uint8_t { Unexplored, Free, Occupied };
    struct Cell {
        State state = State::Unexplored;
        float confidence = 0.0F;  ///< certainty of the cell's state, 0 to 1
        float cleared =
            -1.0F;  ///< how surely a victim would have been seen here, 0 to 1; below 0: no camera looked here
    };
    double cell = 0.05;                                ///< [m]
    Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< corner of cell (0, 0) with the lowest x and y [m]
    int columns = 0, rows = 0;                         ///< number of cells along x and y
    std::vector<Cell> cells;                           ///< row by row

    [[nodiscard]] bool empty() const { return cells.empty(); }
    /// Returns the cell at a place in the map [m]; outside, returns an unexplored cell.
    [[nodiscard]] Cell at(double x, double y) const;
};

/// Makes the map of @p evidence within @p band above @p floor. A cell is occupied if any of its cubes in the
/// band is. Otherwise it is free if a ray passed through one of these cubes, or if its floor was seen.
[[nodiscard]] OccupancyGrid gridOf(const VoxelEvidence& evidence, const FloorHeights& floor,
                                   const HeightBand& band);

/// Returns the area of free and occupied cells [m2].
[[nodiscard]] double exploredArea(const OccupancyGrid& grid);

}  // namespace leitstand
