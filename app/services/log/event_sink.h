#pragma once

namespace leitstand {

struct Event;

/// Receives the events of a mission: live, or from its log.
class EventSink {
public:
    EventSink() = default;
    EventSink(const EventSink&) = delete;
    EventSink& operator=(const EventSink&) = delete;
    virtual ~EventSink() = default;

    /// Takes all events of the mission, in order. One call at a time; must not block its caller.
    virtual void onEvent(const Event& event) = 0;
    /// Ends the sink's own work. None is done after this has returned, though events may still arrive. Any
    /// thread.
    virtual void close() {}
};

}  // namespace leitstand
