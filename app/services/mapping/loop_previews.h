#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>

#include "core/mapping/live/loops/loop_preview.h"
#include "core/mission/loops/open_loops.h"

namespace leitstand {

class LiveMapping;

/// Previews of the map for the operator's open question about a loop closure, as if both places were the
/// same. Any thread; must outlive the mapping's threads.
class LoopPreviews {
public:
    /// Returns the newest preview of @p loop; null before there is one. Makes @p mapping compute previews,
    /// one at a time: at once for a new question, and again after the map has changed, at most every two
    /// seconds. @p map: a number that changes with the map.
    [[nodiscard]] LoopPreviewPtr of(const OpenLoop& loop, std::uint64_t map, LiveMapping& mapping);

private:
    std::mutex m_mutex;
    std::uint64_t m_asked = 0;  ///< OpenLoop::event of the newest request; 0: none
    std::uint64_t m_map = 0;    ///< number of the map for which the newest preview was begun
    std::chrono::steady_clock::time_point m_began{};
    bool m_works = false;
    LoopPreviewPtr m_preview;  ///< newest
};

}  // namespace leitstand
