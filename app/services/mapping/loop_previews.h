#pragma once

#include <mutex>
#include <optional>

#include "core/mapping/live/loops/loop_preview.h"
#include "core/mission/loops/open_loops.h"

namespace leitstand {

class LiveMapping;

/// The preview of the place about which the operator is asked. Any thread; outlives the mapping's threads.
class LoopPreviews {
public:
    /// Null until @p mapping has worked it out, once for each question and each time the map moves.
    [[nodiscard]] LoopPreviewPtr of(const OpenLoop& loop, LiveMapping& mapping);

private:
    std::mutex m_mutex;
    std::optional<OpenLoop> m_asked;  ///< newest
    LoopPreviewPtr m_preview;         ///< of it
};

}  // namespace leitstand
