#include "core/handin/report_search.h"

#include <algorithm>

#include "core/mission/coverage/search_book.h"

namespace leitstand {

std::vector<StoreyCoverage> coverageOf(std::span<const ReportScan> scans, std::span<const SearchView> views,
                                       std::span<const Eigen::Vector3d> trail) {
    SearchBook book;
    std::uint64_t nameless = std::uint64_t{1} << 63U;  // ids of a mission begin with 1
    for (ReportScan scan : scans) {
        if (scan.id == 0) scan.id = nameless++;  // of a bag without key scans
        book.add(scan);
    }
    for (const SearchView& view : views) (void)book.add(view);
    return book.byStorey(trail);
}

ReportSearch searchOf(std::span<const StoreyCoverage> storeys, std::span<const SearchView> views) {
    ReportSearch search;
    for (const StoreyCoverage& one : storeys) search.reachable += one.map->ground().reachableArea();
    if (!(search.reachable > 0.0)) return search;
    for (const SearchSensor sensor : SearchSensors) {
        // In a bag without key scans it is unknown where cameras looked; some robots have no cameras.
        const bool looked = sensor == SearchSensor::Scanner ||
                            std::any_of(views.begin(), views.end(),
                                        [sensor](const SearchView& view) { return view.sensor == sensor; });
        if (!looked) continue;
        ReportSearch::Sensor& reported = search.sensors.emplace_back();
        reported.sensor = sensor;
        for (const StoreyCoverage& one : storeys) reported.seen += one.map->seenArea(sensor);
        reported.missed = missed(storeys, sensor);
    }
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
