#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/mission/coverage/floor_tint.h"
#include "core/mission/coverage/missed_floor.h"

namespace leitstand {

/// How much of a storey was searched.
struct SearchedStorey {
    int number = 0;
    double reachable = 0.0;                           ///< floor that robots can reach [m2]
    std::array<double, SearchSensors.size()> seen{};  ///< seen part of it by each SearchSensor [m2]
};

/// What each kind of sensor has searched: all that a window shows about the search, ready to paint. Immutable
/// once shared.
struct SearchedFloor {
    /// What one kind of sensor saw and missed.
    struct Part {
        double seen = 0.0;                 ///< reachable floor that it saw [m2]
        std::vector<MissedRegion> missed;  ///< largest first
        FloorTint tint;
    };
    double reachable = 0.0;               ///< floor that robots can reach, of all storeys [m2]
    std::vector<SearchedStorey> storeys;  ///< from the lowest to the highest
    std::array<Part, SearchSensors.size()> parts;

    [[nodiscard]] const Part& by(SearchSensor sensor) const {
        return parts[static_cast<std::size_t>(sensor)];
    }
};
using SearchedFloorPtr = std::shared_ptr<const SearchedFloor>;

[[nodiscard]] SearchedFloorPtr searchedFloorOf(const std::vector<StoreyCoverage>& storeys);
/// Returns the patches of @p sensor to paint. They are not copied and keep @p searched alive; null when
/// @p searched is null.
[[nodiscard]] FloorTintPtr tintOf(const SearchedFloorPtr& searched, SearchSensor sensor);

}  // namespace leitstand
