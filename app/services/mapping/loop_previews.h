#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>

#include "core/mapping/live/loops/loop_preview.h"
#include "core/mission/loops/open_loops.h"

namespace leitstand {

class LiveMapping;

/// What would come of an answer to the place about which the operator is asked. Any thread; outlives the
/// mapping's threads.
class LoopPreviews {
public:
    /// The newest of that question, null before there is one. Has @p mapping work it out, one at a time: for
    /// a new question at once, and again where the map went on, which @p map tells by another number, two
    /// seconds after the one before at the earliest.
    [[nodiscard]] LoopPreviewPtr of(const OpenLoop& loop, std::uint64_t map, LiveMapping& mapping);

private:
    std::mutex m_mutex;
    std::uint64_t m_asked = 0;  ///< OpenLoop::event; 0: nothing was
    std::uint64_t m_map = 0;    ///< for which it was begun last
    std::chrono::steady_clock::time_point m_began{};
    bool m_works = false;
    LoopPreviewPtr m_preview;  ///< newest
};

}  // namespace leitstand
