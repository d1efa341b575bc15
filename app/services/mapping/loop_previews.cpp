#include "app/services/mapping/loop_previews.h"

#include <utility>

#include "app/services/mapping/live_mapping.h"

namespace leitstand {

LoopPreviewPtr LoopPreviews::of(const OpenLoop& loop, LiveMapping& mapping) {
    {
        const std::lock_guard lock(m_mutex);
        if (m_asked == loop) return m_preview;
        m_asked = loop;
        m_preview = nullptr;
    }
    mapping.preview(answerTo(loop, true, {}, {}).links, [this, loop](LoopPreview preview) {
        const std::lock_guard lock(m_mutex);
        if (m_asked == loop) m_preview = std::make_shared<const LoopPreview>(std::move(preview));
    });
    return nullptr;
}

}  // namespace leitstand
