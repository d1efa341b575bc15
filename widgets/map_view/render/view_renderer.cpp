#include "widgets/map_view/render/view_renderer.h"

#include <future>
#include <mutex>
#include <optional>
#include <utility>

#include "widgets/map_view/render/egl_context.h"
#include "widgets/map_view/render/render_thread.h"

namespace leitstand {

/// State shared by the GUI and the render thread. It lives until both have released it.
struct ViewRenderer::Shared {
    std::mutex mutex;  // guards all but the scene
    Callbacks callbacks;
    SceneContentPtr content;  ///< not yet handed to the scene
    std::optional<DrawOrder> order;
    bool taskPosted = false;
    bool failed = false;

    std::unique_ptr<Scene> scene;  ///< render thread only

    /// Creates the scene on first use and hands it new content; false when drawing is impossible.
    bool prepare(const Result<std::unique_ptr<EglDisplay>>& display);
    void drawNewest(const Result<std::unique_ptr<EglDisplay>>& display);
    void fail(const Error& error);
};

void ViewRenderer::Shared::fail(const Error& error) {
    const std::lock_guard lock(mutex);
    if (!std::exchange(failed, true) && callbacks.onFailure) callbacks.onFailure(error.text);
}

bool ViewRenderer::Shared::prepare(const Result<std::unique_ptr<EglDisplay>>& display) {
    if (!display) {
        fail(display.error());
        return false;
    }
    if (!scene) {
        auto created = Scene::create(*display.value());
        if (!created) {
            fail(created.error());
            return false;
        }
        scene = std::move(created).value();
    }
    SceneContentPtr fresh;
    {
        const std::lock_guard lock(mutex);
        fresh = std::exchange(content, nullptr);
    }
    if (fresh) scene->setContent(std::move(fresh));
    return true;
}

void ViewRenderer::Shared::drawNewest(const Result<std::unique_ptr<EglDisplay>>& display) {
    std::optional<DrawOrder> wanted;
    {
        const std::lock_guard lock(mutex);
        taskPosted = false;
        wanted = std::exchange(order, std::nullopt);
    }
    if (!wanted || !prepare(display)) return;
    MapPicture picture = scene->draw(*wanted, [this] {
        const std::lock_guard lock(mutex);
        return order.has_value() || !callbacks.onPicture;
    });
    const std::lock_guard lock(mutex);
    if (callbacks.onPicture) callbacks.onPicture(std::move(picture));
}

ViewRenderer::ViewRenderer(Callbacks callbacks)
    : m_thread(RenderThread::shared()), m_shared(std::make_shared<Shared>()) {
    m_shared->callbacks = std::move(callbacks);
}

ViewRenderer::~ViewRenderer() {
    {
        const std::lock_guard lock(m_shared->mutex);
        m_shared->callbacks = {};
        m_shared->order.reset();
    }
    m_thread->post([shared = m_shared](const auto&) { shared->scene.reset(); });
}

void ViewRenderer::setContent(SceneContentPtr content) {
    const std::lock_guard lock(m_shared->mutex);
    m_shared->content = std::move(content);
}

void ViewRenderer::draw(const DrawOrder& order) {
    {
        const std::lock_guard lock(m_shared->mutex);
        m_shared->order = order;
        if (std::exchange(m_shared->taskPosted, true)) return;
    }
    m_thread->post([shared = m_shared](const auto& display) { shared->drawNewest(display); });
}

MapPicture ViewRenderer::drawNow(DrawOrder order) {
    order.full = true;
    std::promise<MapPicture> promise;
    auto future = promise.get_future();
    m_thread->post([shared = m_shared, &promise, &order](const auto& display) {
        MapPicture picture;
        if (shared->prepare(display)) picture = shared->scene->draw(order, [] { return false; });
        promise.set_value(std::move(picture));
    });
    return future.get();
}

}  // namespace leitstand
