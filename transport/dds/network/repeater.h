#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace leitstand::detail {

/// Does what it is given a little later, on a thread of its own and in the order given. Any thread.
class Repeater {
public:
    /// What would make more than @p mostBytes wait is not done at all.
    Repeater(std::chrono::milliseconds delay, std::size_t mostBytes);
    ~Repeater();  ///< what is left is not done
    Repeater(const Repeater&) = delete;
    Repeater& operator=(const Repeater&) = delete;

    /// @p bytes: how much @p what keeps.
    void later(std::size_t bytes, std::function<void()> what);
    /// Does what is left now; what is given from here on is done at once, by who gives it.
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
    std::mutex m_mutex;  // of all that follows
    std::condition_variable m_changed;
    std::deque<Task> m_tasks;
    std::size_t m_bytes = 0;
    bool m_finished = false;
    std::jthread m_thread;  // last member: joined first
};

}  // namespace leitstand::detail
