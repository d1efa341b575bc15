#pragma once

#include <span>
#include <vector>

#include "core/handin/map/occupancy_grid.h"
#include "core/mapping/report_scan.h"
#include "core/mission/coverage/coverage_map.h"
#include "core/mission/coverage/missed_floor.h"

namespace leitstand {

/// What a report says of the search.
struct ReportSearch {
    /// One kind of sensor.
    struct Sensor {
        SearchSensor sensor = SearchSensor::Scanner;
        double seen = 0.0;                 ///< of the floor that can be reached [m2]
        std::vector<MissedRegion> missed;  ///< the largest first
    };
    double reachable = 0.0;       ///< floor that robots can reach, of all storeys [m2]
    std::vector<Sensor> sensors;  ///< by SearchSensors; none that did not look at all
};

/// What was searched with @p views, which hang on @p scans, of each storey. @p trail: base_link where robots
/// were, in the map [m].
[[nodiscard]] std::vector<StoreyCoverage> coverageOf(std::span<const ReportScan> scans,
                                                     std::span<const SearchView> views,
                                                     std::span<const Eigen::Vector3d> trail);
/// What @p views looked at of @p storeys, all together.
[[nodiscard]] ReportSearch searchOf(std::span<const StoreyCoverage> storeys,
                                    std::span<const SearchView> views);

/// Tells the cells of @p grid where no victim was, since a camera would have shown one.
void markCleared(OccupancyGrid& grid, const CoverageMap& coverage);

}  // namespace leitstand
