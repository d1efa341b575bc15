#pragma once

#include <cstdint>
#include <map>

#include "core/mapping/live/map/live_map.h"

namespace leitstand {

/// A key scan that is to be looked for where the map does not expect it: in its earlier part, anywhere.
struct SoughtPlace {
    std::uint64_t scan = 0;                  ///< id
    LiveMapPtr map;                          ///< with it
    std::map<std::uint64_t, double> lately;  ///< scans nearly certain to lie right to it: not looked at
    bool elsewhere = false;  ///< only parts of the map are looked at that have not met its own yet
};

}  // namespace leitstand
