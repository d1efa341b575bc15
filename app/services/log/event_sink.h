#pragma once

#include "core/event/event.h"

namespace leitstand {

/// Follows a mission: live, or from its log.
class EventSink {
public:
    EventSink() = default;
    EventSink(const EventSink&) = delete;
    EventSink& operator=(const EventSink&) = delete;
    virtual ~EventSink() = default;

    /// All events of the mission, in order. One at a time; must not hold its caller up.
    virtual void onEvent(const Event& event) = 0;
    /// Does nothing more of its own once this has returned, though events may still come. Any thread.
    virtual void close() {}
};

}  // namespace leitstand
