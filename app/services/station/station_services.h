#pragma once

#include <vector>

#include "app/services/log/event_sink.h"

namespace leitstand {

/// The parts of a station that follow its mission: in which order they hear of an event, and come to an end.
class StationServices {
public:
    /// @p service, which outlives this, is the next. Not while events come.
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
