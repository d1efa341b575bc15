#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace leitstand::detail {

/// Runs tasks after a delay, on its own thread and in the given order. Any thread.
class Repeater {
public:
    /// Drops a task if it and the waiting tasks would hold more than @p mostBytes of memory.
    Repeater(std::chrono::milliseconds delay, std::size_t mostBytes);
    ~Repeater();  ///< drops the waiting tasks
    Repeater(const Repeater&) = delete;
    Repeater& operator=(const Repeater&) = delete;

    /// Runs @p what after the delay. @p bytes: memory that @p what holds.
    void later(std::size_t bytes, std::function<void()> what);
    /// Runs the waiting tasks now. Tasks that are added after this run at once, on the caller's thread.
    void finish();

private:
    using Clock = std::chrono::steady_clock;
    struct Task {
        Clock::time_point due;
        std::size_t bytes;
        std::function<void()> what;
    };
    void run();

    const std::chrono::milliseconds m_delay;
    const std::size_t m_mostBytes;
    std::mutex m_mutex;  // guards all that follows
    std::condition_variable m_changed;
    std::deque<Task> m_tasks;
    std::size_t m_bytes = 0;
    bool m_finished = false;
    std::jthread m_thread;  // last member: joined first
};

}  // namespace leitstand::detail
