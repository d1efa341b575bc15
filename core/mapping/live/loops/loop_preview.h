#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>

#include "core/base/pose.h"
#include "core/event/scan_links.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/loops/map_problem.h"
#include "core/mapping/live/map/live_map.h"

namespace leitstand {

/// What a map would become if links counted that are a question so far.
struct LoopPreview {
    std::map<std::uint64_t, Pose> moved;  ///< key scans that would move noticeably, and where to in the map
    double largest = 0.0;                 ///< the farthest of these moves [m]
    bool contradicted = false;  ///< the other links speak against these, which would be taken out again
};
using LoopPreviewPtr = std::shared_ptr<const LoopPreview>;

/// Of @p map, whose LiveMapper::problemWith(@p links) has @p solution.
[[nodiscard]] LoopPreview previewOf(const LiveMap& map, const MapSolution& solution,
                                    std::span<const Link> links, const LoopSettings& settings);

}  // namespace leitstand
