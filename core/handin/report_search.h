#pragma once

#include <span>
#include <vector>

#include "core/handin/map/occupancy_grid.h"
#include "core/mapping/report_scan.h"
#include "core/mission/coverage/coverage_map.h"
#include "core/mission/coverage/missed_floor.h"

namespace leitstand {

/// What a report states about the search.
struct ReportSearch {
    /// One kind of sensor.
    struct Sensor {
        SearchSensor sensor = SearchSensor::Scanner;
        double seen = 0.0;                 ///< of the reachable floor [m2]
        std::vector<MissedRegion> missed;  ///< the largest first
    };
    double reachable = 0.0;       ///< floor that robots can reach, of all storeys [m2]
    std::vector<Sensor> sensors;  ///< in the order of SearchSensors; without those that did not look at all
};

/// Computes what was searched of each storey with @p views, which hang on @p scans. @p trail: base_link where
/// robots were, in the map [m].
[[nodiscard]] std::vector<StoreyCoverage> coverageOf(std::span<const ReportScan> scans,
                                                     std::span<const SearchView> views,
                                                     std::span<const Eigen::Vector3d> trail);
/// Returns what @p views searched of all @p storeys together.
[[nodiscard]] ReportSearch searchOf(std::span<const StoreyCoverage> storeys,
                                    std::span<const SearchView> views);

/// Sets in the free cells of @p grid how surely a camera would have shown a victim there.
void markCleared(OccupancyGrid& grid, const CoverageMap& coverage);

}  // namespace leitstand
