#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

#include "core/event/raw_event.h"

namespace leitstand {

/// Puts all events that reach the station into one order (docs/design.md, "A mission is its log"). Numbers
/// them and passes them to a sink on its own thread. Events that wait at the same time are ordered by receive
/// time. Receive times never decrease, even when the station's clock is set back. The sink must not wait for
/// the disk or the network, so that the queue stays short. The queue is not limited, since nothing may be
/// lost here.
class Sequencer {
public:
    using Sink = std::function<void(const RawEvent&)>;

    /// Numbers events from @p lastSequence + 1 on.
    Sequencer(std::uint64_t lastSequence, Sink sink);
    /// Passes on the waiting events, then ends.
    ~Sequencer();
    Sequencer(const Sequencer&) = delete;
    Sequencer& operator=(const Sequencer&) = delete;

    /// Takes @p event. If it has no receive time, sets it to now. Any thread, also that of the sink.
    void push(RawEvent event);
    /// Waits until all events pushed before were passed on. Must not be called from the sink.
    void drain();

private:
    void run(const std::stop_token& stop);

    Sink m_sink;
    std::uint64_t m_sequence;
    Time m_last{};
    std::mutex m_mutex;
    std::condition_variable_any m_changed;
    std::deque<RawEvent> m_waiting;
    std::uint64_t m_pushed = 0, m_handedOver = 0;
    std::jthread m_thread;  ///< the last member, so that it is joined first
};

/// Returns the time of the station's clock.
[[nodiscard]] Time stationTime();

}  // namespace leitstand
