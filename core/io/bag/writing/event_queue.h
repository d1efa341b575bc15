#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "core/event/raw_event.h"

namespace leitstand::detail {

/// Events that wait for the disk, bounded in bytes; pictures are dropped first. Not thread-safe. Events that
/// take() returned still count in bytes() and events() until settle().
class EventQueue {
public:
    using Clock = std::chrono::steady_clock;
    /// Sizes of the queue [B]: above @p droppableBound new pictures are dropped, above @p bound all new
    /// events.
    EventQueue(std::size_t droppableBound, std::size_t bound)
        : m_droppableBound(droppableBound), m_bound(bound) {}

    /// Queues or drops @p event. A picture is dropped when the queue would exceed the bound for pictures.
    /// When any event would exceed the bound for all events, waiting pictures are dropped first. If that is
    /// not enough, @p event is dropped too.
    void push(RawEvent event, bool droppable, Clock::time_point now);
    /// Takes the oldest events: at least one, together about @p bytes [B].
    [[nodiscard]] std::vector<RawEvent> take(std::size_t bytes);
    /// Notes that an event returned by take() was written, or could not be written and was dropped.
    void settle(const RawEvent& event);
    /// Sets whether pictures are dropped at once, because the disk is full. If so, waiting pictures are
    /// dropped too.
    void refuseDroppables(bool refuse);
    /// Counts @p event as dropped, without queueing it.
    void drop(const RawEvent& event, bool droppable);

    [[nodiscard]] bool empty() const { return m_events.empty(); }
    /// Returns when the oldest waiting event was queued, or @p otherwise when no event waits.
    [[nodiscard]] Clock::time_point oldest(Clock::time_point otherwise) const {
        return m_events.empty() ? otherwise : m_events.front().came;
    }
    /// Bytes of events that take() has not returned yet.
    [[nodiscard]] std::size_t waitingBytes() const { return m_waitingBytes; }
    [[nodiscard]] std::size_t bytes() const { return m_waitingBytes + m_takenBytes; }
    [[nodiscard]] std::size_t events() const { return m_events.size() + m_taken; }
    [[nodiscard]] const std::map<std::string, std::uint64_t>& dropped() const { return m_dropped; }
    [[nodiscard]] std::uint64_t droppedPictures() const { return m_droppedPictures; }
    /// Number of dropped events, without pictures.
    [[nodiscard]] std::uint64_t lostEvents() const { return m_lost; }
    /// Returns the sequence of the oldest waiting event, or @p otherwise when no event waits.
    [[nodiscard]] std::uint64_t first(std::uint64_t otherwise) const {
        return m_events.empty() ? otherwise : m_events.front().event.sequence;
    }

    /// Memory that @p event takes [B].
    [[nodiscard]] static std::size_t sizeOf(const RawEvent& event);

private:
    struct Waiting {
        RawEvent event;
        bool droppable = false;
        Clock::time_point came{};
    };
    void removeDroppables();

    std::size_t m_droppableBound, m_bound;
    std::deque<Waiting> m_events;
    std::size_t m_waitingBytes = 0, m_takenBytes = 0, m_taken = 0, m_droppables = 0;
    bool m_refuse = false;
    std::map<std::string, std::uint64_t> m_dropped;
    std::uint64_t m_droppedPictures = 0, m_lost = 0;
};

}  // namespace leitstand::detail
