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

/// How a map changes by an answer to a question about a loop.
struct LoopPreview {
    std::map<std::uint64_t, Pose> moved;  ///< new poses in the map of key scans that visibly move, by id
    double largest = 0.0;                 ///< the farthest of these moves [m]
    std::size_t parted = 0;  ///< number of other loop links that contradict the answer, and do not count then
};
using LoopPreviewPtr = std::shared_ptr<const LoopPreview>;

/// Returns the preview for @p map. @p solution: that of its LiveMapper::problemWith().
[[nodiscard]] LoopPreview previewOf(const LiveMap& map, const MapSolution& solution,
                                    const LoopSettings& settings);

}  // namespace leitstand
