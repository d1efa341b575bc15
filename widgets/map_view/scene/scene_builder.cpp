#include "widgets/map_view/scene/scene_builder.h"

#include <utility>

namespace leitstand {

SceneBuilder::SceneBuilder(std::function<void(SceneContentPtr)> onContent)
    : m_onContent(std::move(onContent)), m_thread([this](const std::stop_token& stop) { run(stop); }) {}

SceneBuilder::~SceneBuilder() = default;

void SceneBuilder::submit(SceneOrder order) {
    {
        const std::lock_guard lock(m_mutex);
        m_newest = order.number;
        m_order = std::move(order);
    }
    m_changed.notify_all();
}

SceneContentPtr SceneBuilder::finished() {
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [this] { return m_done->order == m_newest; });
    return m_done;
}

void SceneBuilder::run(const std::stop_token& stop) {
    SceneAssembler assembler;
    const auto interrupted = [this, &stop] {
        const std::lock_guard lock(m_mutex);
        return stop.stop_requested() || m_order.has_value();
    };
    while (true) {
        SceneOrder order;
        {
            std::unique_lock lock(m_mutex);
            if (!m_changed.wait(lock, stop, [this] { return m_order.has_value(); })) return;
            order = *std::exchange(m_order, std::nullopt);
        }
        SceneContentPtr content = assembler.assemble(order, interrupted, m_onContent);
        if (!content) continue;
        {
            const std::lock_guard lock(m_mutex);
            m_done = content;
        }
        m_changed.notify_all();
        m_onContent(std::move(content));
    }
}

}  // namespace leitstand
