#include "transport/dds/network/repeater.h"

#include <utility>

namespace leitstand::detail {

Repeater::Repeater(std::chrono::milliseconds delay, std::size_t mostBytes)
    : m_delay(delay), m_mostBytes(mostBytes), m_thread([this] { run(); }) {}

Repeater::~Repeater() {
    {
        const std::scoped_lock lock(m_mutex);
        m_finished = true;
        m_tasks.clear();
    }
    m_changed.notify_one();
    if (m_thread.joinable()) m_thread.join();
}

void Repeater::later(std::size_t bytes, std::function<void()> what) {
    {
        const std::scoped_lock lock(m_mutex);
        if (!m_finished) {
            if (m_bytes + bytes > m_mostBytes) return;
            m_bytes += bytes;
            m_tasks.push_back({Clock::now() + m_delay, bytes, std::move(what)});
            what = nullptr;
        }
    }
    m_changed.notify_one();
    if (what) what();
}

void Repeater::finish() {
    {
        const std::scoped_lock lock(m_mutex);
        m_finished = true;
    }
    m_changed.notify_one();
    if (m_thread.joinable()) m_thread.join();
}

void Repeater::run() {
    std::unique_lock lock(m_mutex);
    for (;;) {
        m_changed.wait(lock, [this] { return m_finished || !m_tasks.empty(); });
        if (m_tasks.empty()) return;
        const auto due = m_tasks.front().due;  // a copy: the task may go meanwhile
        m_changed.wait_until(lock, due, [this] { return m_finished; });
        if (m_tasks.empty()) return;  // cleared by the destructor
        const Task task = std::move(m_tasks.front());
        m_tasks.pop_front();
        m_bytes -= task.bytes;
        lock.unlock();
        task.what();
        lock.lock();
    }
}

}  // namespace leitstand::detail
