#pragma once

#include <cstdint>
#include <map>

#include "core/mapping/live/map/live_map.h"

namespace leitstand {

/// A key scan that is looked for where the map does not expect it: anywhere in its earlier part.
struct SoughtPlace {
    std::uint64_t scan = 0;  ///< id of the scan
    LiveMapPtr map;          ///< map that contains the scan
    /// Scans that are not searched, as their relative pose is nearly certain: id -> distance over the graph
    /// [m].
    std::map<std::uint64_t, double> lately;
    bool elsewhere = false;  ///< search only in parts of the map that are not joined with the scan's part
};

}  // namespace leitstand
