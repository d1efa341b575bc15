#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/mission/coverage/coverage_map.h"

namespace leitstand {

/// A connected piece of floor that robots can reach and one kind of sensor did not see.
struct MissedRegion {
    double area = 0.0;  ///< [m2]
    /// Point of the region that is nearest to its middle [m].
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    double height = 0.0;  ///< height of the floor at `place` [m]
    int storey = 0;       ///< number of its storey
    /// Corners of its bounding box [m].
    Eigen::Vector2d low = Eigen::Vector2d::Zero(), high = Eigen::Vector2d::Zero();
};

/// Returns the reachable floor that @p sensor did not see, the largest piece first. Pieces smaller than
/// CoverageSettings::leastMissed are left out.
[[nodiscard]] std::vector<MissedRegion> missed(const CoverageMap& coverage, SearchSensor sensor);
/// Returns the missed floor of all @p storeys, the largest piece first.
[[nodiscard]] std::vector<MissedRegion> missed(std::span<const StoreyCoverage> storeys, SearchSensor sensor);

}  // namespace leitstand
