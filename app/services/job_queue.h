#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>

namespace leitstand {

/// Jobs for one worker, in order, each with its own stop source. cancel() stops both the running job and jobs
/// that have not begun.
class JobQueue {
public:
    /// What a worker runs. Stop is requested on @p cancelled when nobody needs the job any more.
    using Job = std::function<void(std::stop_token cancelled)>;

    /// Adds @p job; any thread. The queue is not limited, since jobs are single requests of an operator.
    void submit(Job job, bool cancellable = true);
    /// Adds @p job in front of all waiting jobs, for a caller that waits for it.
    void submitFirst(Job job);
    /// Cancels the running job and all waiting jobs, except those that are not cancellable. Cancelled jobs
    /// are still run, and can see that they are cancelled.
    void cancel();
    /// Runs jobs until @p stop is requested.
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
    std::optional<std::stop_source> m_atWork;  ///< stop source of the running job, if it is cancellable
};

}  // namespace leitstand
