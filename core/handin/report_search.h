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
        double seen = 0.0;                 ///< seen part of the reachable floor [m2]
        std::vector<MissedRegion> missed;  ///< the largest first
    };
    double reachable = 0.0;       ///< floor that robots can reach, of all storeys [m2]
    std::vector<Sensor> sensors;  ///< in the order of SearchSensors; sensors that never looked are left out
};

/// Computes what @p scans and @p views searched on each storey. Each view is relative to one of @p scans.
/// @p trail: places of base_link where robots were, in the map [m].
[[nodiscard]] std::vector<StoreyCoverage> coverageOf(std::span<const ReportScan> scans,
                                                     std::span<const SearchView> views,
                                                     std::span<const Eigen::Vector3d> trail);
/// Returns what @p views searched of all @p storeys together.
[[nodiscard]] ReportSearch searchOf(std::span<const StoreyCoverage> storeys,
                                    std::span<const SearchView> views);

/// Sets Cell::cleared of the free cells of @p grid: how surely a camera would have shown a victim there.
void markCleared(OccupancyGrid& grid, const CoverageMap& coverage);

}  // namespace leitstand
