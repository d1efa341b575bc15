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

/// How an answer to a question about a loop changes the map.
struct LoopPreview {
    /// New poses in the map, by scan id; only key scans that move visibly.
    std::map<std::uint64_t, Pose> moved;
    double largest = 0.0;  ///< largest of these moves [m]
    /// Number of other loop links that contradict the answer, and would be ignored after it.
    std::size_t parted = 0;
};
using LoopPreviewPtr = std::shared_ptr<const LoopPreview>;

/// Returns the preview for @p map. @p solution: solution of LiveMapper::problemWith() with the answer.
[[nodiscard]] LoopPreview previewOf(const LiveMap& map, const MapSolution& solution,
                                    const LoopSettings& settings);

}  // namespace leitstand
