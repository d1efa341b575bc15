#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>

#include "core/mapping/live/loops/loop_preview.h"
#include "core/mission/loops/open_loops.h"

namespace leitstand {

class LiveMapping;

/// Previews of what an answer to the operator's open loop question would do to the map. Any thread; outlives
/// the mapping's threads.
class LoopPreviews {
public:
    /// Returns the newest preview of @p loop; null before there is one. Makes @p mapping compute it, one at a
    /// time. Computes at once for a new question, and again when the map changed (another number @p map),
    /// every two seconds at most.
    [[nodiscard]] LoopPreviewPtr of(const OpenLoop& loop, std::uint64_t map, LiveMapping& mapping);

private:
    std::mutex m_mutex;
    std::uint64_t m_asked = 0;  ///< OpenLoop::event; 0: nothing was
    std::uint64_t m_map = 0;    ///< the number of the map that it was begun for last
    std::chrono::steady_clock::time_point m_began{};
    bool m_works = false;
    LoopPreviewPtr m_preview;  ///< newest
};

}  // namespace leitstand
