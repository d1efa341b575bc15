#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "core/base/result.h"

namespace leitstand {

class EglDisplay;

/// The single thread on which VTK draws for all views of the process, since VTK and EGL keep state per
/// thread.
class RenderThread {
public:
    using Task = std::function<void(const Result<std::unique_ptr<EglDisplay>>& display)>;

    /// Returns the running thread, or a new one. It ends when its last owner releases it.
    [[nodiscard]] static std::shared_ptr<RenderThread> shared();

    RenderThread();
    /// Waits until all tasks are done.
    ~RenderThread();

    /// Any thread. Tasks run on the render thread one after another, in the order in which they were posted.
    /// They receive the connection to EGL, or the error if there is none.
    void post(Task task);

private:
    void run(const std::stop_token& stop);

    std::mutex m_mutex;
    std::condition_variable_any m_posted;
    std::deque<Task> m_tasks;
    std::jthread m_thread;  // last member: joined first
};

}  // namespace leitstand
