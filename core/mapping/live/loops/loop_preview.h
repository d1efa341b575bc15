#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>

#include "core/base/pose.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/loops/map_problem.h"
#include "core/mapping/live/map/live_map.h"

namespace leitstand {

/// What an answer to a question makes of a map.
struct LoopPreview {
    std::map<std::uint64_t, Pose> moved;  ///< key scans that would visibly move, and where to in the map
    double largest = 0.0;                 ///< the farthest of these moves [m]
    std::size_t parted = 0;  ///< other links of loops that would contradict it, and no longer count
};
using LoopPreviewPtr = std::shared_ptr<const LoopPreview>;

/// Returns the preview of @p map, whose LiveMapper::problemWith() has @p solution.
[[nodiscard]] LoopPreview previewOf(const LiveMap& map, const MapSolution& solution,
                                    const LoopSettings& settings);

}  // namespace leitstand
