#include "app/services/log/sequencer.h"

#include <algorithm>
#include <utility>

namespace leitstand {

Sequencer::Sequencer(std::uint64_t lastSequence, Sink sink)
    : m_sink(std::move(sink)),
      m_sequence(lastSequence),
      m_thread([this](const std::stop_token& stop) { run(stop); }) {}

Sequencer::~Sequencer() = default;

void Sequencer::push(RawEvent event) {
    if (event.received == Time{}) event.received = stationTime();
    {
        const std::lock_guard lock(m_mutex);
        m_waiting.push_back(std::move(event));
        ++m_pushed;
    }
    m_changed.notify_all();
}

void Sequencer::drain() {
    std::unique_lock lock(m_mutex);
    const std::uint64_t upTo = m_pushed;
    m_changed.wait(lock, [&] { return m_handedOver >= upTo; });
}

void Sequencer::run(const std::stop_token& stop) {
    for (;;) {
        std::deque<RawEvent> batch;
        {
            std::unique_lock lock(m_mutex);
            m_changed.wait(lock, stop, [this] { return !m_waiting.empty(); });
            if (m_waiting.empty()) return;
            batch.swap(m_waiting);
        }
        std::stable_sort(batch.begin(), batch.end(),
                         [](const RawEvent& a, const RawEvent& b) { return a.received < b.received; });
        for (RawEvent& event : batch) {
            event.sequence = ++m_sequence;
            m_last = event.received = std::max(event.received, m_last);
            m_sink(event);
        }
        {
            const std::lock_guard lock(m_mutex);
            m_handedOver += batch.size();
        }
        m_changed.notify_all();
    }
}

Time stationTime() {
    return std::chrono::time_point_cast<std::chrono::nanoseconds>(std::chrono::system_clock::now());
}

}  // namespace leitstand
