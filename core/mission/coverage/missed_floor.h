#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/mission/coverage/coverage_map.h"

namespace leitstand {

/// Floor in one piece that robots can reach and that a kind of sensor did not see.
struct MissedRegion {
    double area = 0.0;                                ///< [m2]
    Eigen::Vector2d place = Eigen::Vector2d::Zero();  ///< within it, next to its middle [m]
    double height = 0.0;                              ///< of the floor there [m]
    int storey = 0;                                   ///< its number
    Eigen::Vector2d low = Eigen::Vector2d::Zero(), high = Eigen::Vector2d::Zero();  ///< its corners [m]
};

/// What was missed: floor that can be reached and that @p sensor did not see, the largest piece first.
/// Pieces smaller than CoverageSettings::leastMissed are left out.
[[nodiscard]] std::vector<MissedRegion> missed(const CoverageMap& coverage, SearchSensor sensor);
/// Likewise, of all @p storeys.
[[nodiscard]] std::vector<MissedRegion> missed(std::span<const StoreyCoverage> storeys, SearchSensor sensor);

}  // namespace leitstand
