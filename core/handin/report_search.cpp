#include "core/handin/report_search.h"

#include <limits>

#include "core/mission/coverage/search_book.h"

namespace leitstand {

CoverageMapPtr coverageOf(std::span<const ReportScan> scans, std::span<const SearchView> views,
                          std::span<const Eigen::Vector3d> trail) {
    SearchBook book;
    std::uint64_t nameless = std::numeric_limits<std::uint64_t>::max();
    for (ReportScan scan : scans) {
        if (scan.id == 0) scan.id = nameless--;  // of a bag without key scans
        book.add(scan);
    }
    for (const SearchView& view : views) (void)book.add(view);
    return book.coverage(trail);
}

ReportSearch searchOf(const CoverageMap& coverage) {
    ReportSearch search;
    search.reachable = coverage.ground().reachableArea();
    if (!(search.reachable > 0.0)) return search;
    for (const SearchSensor sensor : SearchSensors)
        search.sensors.push_back({sensor, coverage.seenArea(sensor), missed(coverage, sensor)});
    return search;
}

void markCleared(OccupancyGrid& grid, const CoverageMap& coverage) {
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            OccupancyGrid::Cell& cell =
                grid.cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) +
                           static_cast<std::size_t>(column)];
            if (cell.state != OccupancyGrid::State::Free) continue;
            cell.cleared =
                coverage.cleared(grid.origin + grid.cell * Eigen::Vector2d(column + 0.5, row + 0.5));
        }
    }
}

}  // namespace leitstand
