#include "app/services/mapping/loop_previews.h"

#include <chrono>
#include <utility>

#include "app/services/mapping/live_mapping.h"

namespace leitstand {
namespace {

constexpr std::chrono::seconds Again(2);

}  // namespace

LoopPreviewPtr LoopPreviews::of(const OpenLoop& loop, std::uint64_t map, LiveMapping& mapping) {
    {
        const std::lock_guard lock(m_mutex);
        if (m_asked != loop.event) {
            m_preview = nullptr;
            m_map = 0;
        }
        m_asked = loop.event;
        const auto now = std::chrono::steady_clock::now();
        const bool rests = m_preview && now - m_began < Again;
        if (m_works || m_map == map || rests) return m_preview;
        m_works = true;
        m_map = map;
        m_began = now;
    }
    mapping.preview(answerTo(loop, true, {}, {}).links, [this, asked = loop.event](LoopPreview preview) {
        const std::lock_guard lock(m_mutex);
        m_works = false;
        if (m_asked == asked) m_preview = std::make_shared<const LoopPreview>(std::move(preview));
    });
    const std::lock_guard lock(m_mutex);
    return m_preview;
}

}  // namespace leitstand
