#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "widgets/map_view/scene/scene_assembler.h"

namespace leitstand {

/// The worker that prepares maps for drawing. Any thread; only the newest order is carried out.
class SceneBuilder {
public:
    /// @p onContent: called on the worker's thread. If there is much to do, it is first called with parts of
    /// the content.
    explicit SceneBuilder(std::function<void(SceneContentPtr)> onContent);
    ~SceneBuilder();

    void submit(SceneOrder order);
    /// Waits for the whole content of the last order, and returns it.
    [[nodiscard]] SceneContentPtr finished();

private:
    void run(const std::stop_token& stop);

    std::function<void(SceneContentPtr)> m_onContent;
    std::mutex m_mutex;
    std::condition_variable_any m_changed;
    std::optional<SceneOrder> m_order;  ///< order that has not been started
    std::uint64_t m_newest = 0;         ///< number of the last order
    SceneContentPtr m_done = std::make_shared<const SceneContent>();
    std::jthread m_thread;  // last member: joined first
};

}  // namespace leitstand
