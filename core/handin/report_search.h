#pragma once

#include <span>
#include <vector>

#include "core/handin/map/occupancy_grid.h"
#include "core/mapping/report_scan.h"
#include "core/mission/coverage/coverage_map.h"
#include "core/mission/coverage/missed_floor.h"

namespace leitstand {

/// What a report says about the search.
struct ReportSearch {
    /// The result for one kind of sensor.
    struct Sensor {
        SearchSensor sensor = SearchSensor::Scanner;
        double seen = 0.0;                 ///< reachable floor that it saw [m2]
        std::vector<MissedRegion> missed;  ///< largest first
    };
    double reachable = 0.0;       ///< floor of all storeys that robots can reach [m2]
    std::vector<Sensor> sensors;  ///< in the order of SearchSensors, without sensors that never looked
};

/// Computes what @p scans and @p views have searched on each storey. Each view is relative to one of
/// @p scans. @p trail: where base_link of robots was in the map [m].
[[nodiscard]] std::vector<StoreyCoverage> coverageOf(std::span<const ReportScan> scans,
                                                     std::span<const SearchView> views,
                                                     std::span<const Eigen::Vector3d> trail);
/// Returns what @p views have searched on all @p storeys together.
[[nodiscard]] ReportSearch searchOf(std::span<const StoreyCoverage> storeys,
                                    std::span<const SearchView> views);

/// Sets Cell::cleared of the free cells in @p grid: how surely a camera would have shown a victim there.
void markCleared(OccupancyGrid& grid, const CoverageMap& coverage);

}  // namespace leitstand
