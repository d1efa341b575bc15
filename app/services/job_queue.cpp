#include "app/services/job_queue.h"

#include <utility>

namespace leitstand {

void JobQueue::submit(Job job, bool cancellable) {
    {
        const std::scoped_lock lock(m_mutex);
        m_waiting.push_back({std::move(job), cancellable, {}});
    }
    m_arrived.notify_one();
}

void JobQueue::submitFirst(Job job) {
    {
        const std::scoped_lock lock(m_mutex);
        m_waiting.push_front({std::move(job), true, {}});
    }
    m_arrived.notify_one();
}

void JobQueue::cancel() {
    const std::scoped_lock lock(m_mutex);
    if (m_atWork) m_atWork->request_stop();
    for (Entry& entry : m_waiting) {
        if (entry.cancellable) entry.stop.request_stop();
    }
}

std::optional<JobQueue::Entry> JobQueue::next(const std::stop_token& stop) {
    std::unique_lock lock(m_mutex);
    m_atWork.reset();
    if (!m_arrived.wait(lock, stop, [this] { return !m_waiting.empty(); })) return std::nullopt;
    Entry entry = std::move(m_waiting.front());
    m_waiting.pop_front();
    if (entry.cancellable) m_atWork = entry.stop;
    return entry;
}

void JobQueue::work(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        const auto entry = next(stop);
        if (!entry) return;
        entry->job(entry->stop.get_token());
    }
}

}  // namespace leitstand
