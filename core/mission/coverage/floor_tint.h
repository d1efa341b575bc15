#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "core/mission/coverage/coverage_map.h"

namespace leitstand {

/// A horizontal rectangle of floor.
struct FloorPatch {
    Eigen::Vector2f low, high;  ///< corners in the map [m]
    float height = 0.0F;        ///< height in the map [m]
    bool seen = false;
};

/// Patches of reachable floor that one kind of sensor saw or missed, for painting.
struct FloorTint {
    SearchSensor sensor = SearchSensor::Camera;
    std::vector<FloorPatch> patches;
};
using FloorTintPtr = std::shared_ptr<const FloorTint>;

/// Returns the reachable floor of @p coverage, joined into few patches. Heights that differ by less than 5 cm
/// are treated as the same.
[[nodiscard]] FloorTint floorTintOf(const CoverageMap& coverage, SearchSensor sensor);

}  // namespace leitstand
