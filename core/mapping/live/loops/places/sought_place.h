#pragma once

#include <cstdint>
#include <map>

#include "core/mapping/live/map/live_map.h"

namespace leitstand {

/// A key scan to be looked for where the map does not expect it: anywhere in its earlier part.
struct SoughtPlace {
    std::uint64_t scan = 0;                  ///< id
    LiveMapPtr map;                          ///< the map with that scan
    std::map<std::uint64_t, double> lately;  ///< not searched: scans whose pose relative to it is nearly
                                             ///< certain, with the distance over the graph [m]
    bool elsewhere = false;  ///< search only parts of the map that have not met the scan's own part
};

}  // namespace leitstand
