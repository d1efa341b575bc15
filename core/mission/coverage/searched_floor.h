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
    std::array<double, SearchSensors.size()> seen{};  ///< of it, by SearchSensor [m2]
};

/// What was searched, told for each kind of sensor: all that a window shows of it, made where it is computed.
/// Immutable once shared.
struct SearchedFloor {
    /// With one kind of sensor.
    struct Part {
        double seen = 0.0;                 ///< of the floor that can be reached [m2]
        std::vector<MissedRegion> missed;  ///< the largest first
        FloorTint tint;
    };
    double reachable = 0.0;               ///< floor that robots can reach, of all storeys [m2]
    std::vector<SearchedStorey> storeys;  ///< from the lowest on
    std::array<Part, SearchSensors.size()> parts;

    [[nodiscard]] const Part& by(SearchSensor sensor) const {
        return parts[static_cast<std::size_t>(sensor)];
    }
};
using SearchedFloorPtr = std::shared_ptr<const SearchedFloor>;

[[nodiscard]] SearchedFloorPtr searchedFloorOf(const std::vector<StoreyCoverage>& storeys);
/// How to paint @p searched; null where nothing is known. Nothing is copied.
[[nodiscard]] FloorTintPtr tintOf(const SearchedFloorPtr& searched, SearchSensor sensor);

}  // namespace leitstand
