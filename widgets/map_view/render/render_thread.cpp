#include "widgets/map_view/render/render_thread.h"

#include <utility>

#include "widgets/map_view/render/egl_context.h"

namespace leitstand {

std::shared_ptr<RenderThread> RenderThread::shared() {
    static std::mutex mutex;
    static std::weak_ptr<RenderThread> running;
    const std::lock_guard lock(mutex);
    std::shared_ptr<RenderThread> thread = running.lock();
    if (!thread) {
        thread = std::make_shared<RenderThread>();
        running = thread;
    }
    return thread;
}

RenderThread::RenderThread() : m_thread([this](const std::stop_token& stop) { run(stop); }) {}

RenderThread::~RenderThread() = default;

void RenderThread::post(Task task) {
    {
        const std::lock_guard lock(m_mutex);
        m_tasks.push_back(std::move(task));
    }
    m_posted.notify_one();
}

void RenderThread::run(const std::stop_token& stop) {
    const auto display = EglDisplay::open();
    while (true) {
        Task task;
        {
            std::unique_lock lock(m_mutex);
            if (!m_posted.wait(lock, stop, [this] { return !m_tasks.empty(); })) return;
            task = std::move(m_tasks.front());
            m_tasks.pop_front();
        }
        task(display);
    }
}

}  // namespace leitstand
