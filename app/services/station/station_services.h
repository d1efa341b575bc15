#pragma once

#include <vector>

#include "app/services/log/event_sink.h"

namespace leitstand {

struct Event;

/// The parts of a station that follow its mission, in the order in which they receive events and are closed.
class StationServices {
public:
    /// Adds @p service as the next part; it must outlive this object. Must not be called while events are
    /// received.
    void add(EventSink& service) { m_services.push_back(&service); }
    void onEvent(const Event& event) const {
        for (EventSink* const service : m_services) service->onEvent(event);
    }
    void close() const {
        for (EventSink* const service : m_services) service->close();
    }

private:
    std::vector<EventSink*> m_services;
};

}  // namespace leitstand
