#include "core/mission/coverage/searched_floor.h"

#include <utility>

namespace leitstand {

SearchedFloorPtr searchedFloorOf(CoverageMapPtr coverage) {
    auto floor = std::make_shared<SearchedFloor>();
    floor->reachable = coverage->ground().reachableArea();
    for (const SearchSensor sensor : SearchSensors) {
        SearchedFloor::Part& part = floor->parts[static_cast<std::size_t>(sensor)];
        part.seen = coverage->seenArea(sensor);
        part.missed = missed(*coverage, sensor);
        part.tint = floorTintOf(*coverage, sensor);
    }
    floor->coverage = std::move(coverage);
    return floor;
}

FloorTintPtr tintOf(const SearchedFloorPtr& searched, SearchSensor sensor) {
    return searched ? FloorTintPtr(searched, &searched->by(sensor).tint) : nullptr;
}

}  // namespace leitstand
