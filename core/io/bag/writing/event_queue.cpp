#include "core/io/bag/writing/event_queue.h"

#include <utility>

namespace leitstand::detail {

std::size_t EventQueue::sizeOf(const RawEvent& event) {
    return sizeof(RawEvent) + (event.cdr ? event.cdr->size() : 0);
}

void EventQueue::push(RawEvent event, bool droppable, Clock::time_point now) {
    const std::size_t size = sizeOf(event);
    const bool refused = droppable && (m_refuse || bytes() + size > m_droppableBound);
    if (!refused && bytes() + size > m_bound) removeDroppables();
    if (refused || bytes() + size > m_bound) {
        drop(event, droppable);
        return;
    }
    m_waitingBytes += size;
    if (droppable) ++m_droppables;
    m_events.push_back({std::move(event), droppable, now});
}

std::vector<RawEvent> EventQueue::take(std::size_t most) {
    std::vector<RawEvent> taken;
    for (std::size_t sum = 0; !m_events.empty() && (taken.empty() || sum < most);) {
        Waiting& front = m_events.front();
        const std::size_t size = sizeOf(front.event);
        sum += size;
        m_waitingBytes -= size;
        m_takenBytes += size;
        ++m_taken;
        if (front.droppable) --m_droppables;
        taken.push_back(std::move(front.event));
        m_events.pop_front();
    }
    return taken;
}

void EventQueue::settle(const RawEvent& event) {
    m_takenBytes -= sizeOf(event);
    --m_taken;
}

void EventQueue::refuseDroppables(bool refuse) {
    m_refuse = refuse;
    if (refuse) removeDroppables();
}

void EventQueue::drop(const RawEvent& event, bool droppable) {
    ++m_dropped[event.topic];
    ++(droppable ? m_droppedPictures : m_lost);
}

void EventQueue::removeDroppables() {
    if (m_droppables == 0) return;
    std::deque<Waiting> kept;
    for (Waiting& waiting : m_events) {
        if (!waiting.droppable) {
            kept.push_back(std::move(waiting));
            continue;
        }
        m_waitingBytes -= sizeOf(waiting.event);
        drop(waiting.event, true);
    }
    m_droppables = 0;
    m_events = std::move(kept);
}

}  // namespace leitstand::detail
