#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>

namespace leitstand {

/// Jobs for one worker, in order, each with a stop source of its own, so that a cancel reaches a job at work
/// as well as one that nobody has begun.
class JobQueue {
public:
    /// What a worker does; is told when nobody wants it any more.
    using Job = std::function<void(std::stop_token cancelled)>;

    /// Adds @p job; any thread. Unbounded: jobs are single wishes of an operator.
    void submit(Job job, bool cancellable = true);
    /// Adds @p job before all that wait: somebody waits for it.
    void submitFirst(Job job);
    /// Cancels the job at work and all that wait, except those that are not cancellable; they still run, and
    /// see that they are cancelled.
    void cancel();
    /// Runs jobs until @p stop.
    void work(const std::stop_token& stop);

private:
    struct Entry {
        Job job;
        bool cancellable = true;
        std::stop_source stop;
    };
    [[nodiscard]] std::optional<Entry> next(const std::stop_token& stop);

    std::mutex m_mutex;
    std::condition_variable_any m_arrived;
    std::deque<Entry> m_waiting;
    std::optional<std::stop_source> m_atWork;  ///< of the job at work, when it is cancellable
};

}  // namespace leitstand
