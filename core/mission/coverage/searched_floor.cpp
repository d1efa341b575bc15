#include "core/mission/coverage/searched_floor.h"

namespace leitstand {

SearchedFloorPtr searchedFloorOf(const std::vector<StoreyCoverage>& storeys) {
    auto floor = std::make_shared<SearchedFloor>();
    for (const StoreyCoverage& one : storeys) {
        SearchedStorey& storey = floor->storeys.emplace_back();
        storey.number = one.storey.number;
        storey.reachable = one.map->ground().reachableArea();
        floor->reachable += storey.reachable;
        for (const SearchSensor sensor : SearchSensors) {
            SearchedFloor::Part& part = floor->parts[static_cast<std::size_t>(sensor)];
            const double seen = one.map->seenArea(sensor);
            storey.seen[static_cast<std::size_t>(sensor)] = seen;
            part.seen += seen;
            const FloorTint tint = floorTintOf(*one.map, sensor);
            part.tint.sensor = sensor;
            part.tint.patches.insert(part.tint.patches.end(), tint.patches.begin(), tint.patches.end());
        }
    }
    for (const SearchSensor sensor : SearchSensors)
        floor->parts[static_cast<std::size_t>(sensor)].missed = missed(storeys, sensor);
    return floor;
}

FloorTintPtr tintOf(const SearchedFloorPtr& searched, SearchSensor sensor) {
    return searched ? FloorTintPtr(searched, &searched->by(sensor).tint) : nullptr;
}

}  // namespace leitstand
