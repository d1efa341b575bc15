#pragma once

#include <cstdint>

#include "core/event/station_samples.h"

namespace leitstand {

/// An alarm as it is now.
struct AlarmState {
    std::uint64_t sequence = 0;  ///< sequence of the newest change
    std::uint64_t raised = 0;    ///< sequence of the event that last raised it
    std::uint64_t times = 0;     ///< how often it was raised
    AlarmSample alarm;
};

/// A period in which a station recorded the mission.
struct SessionState {
    std::uint64_t started = 0;  ///< sequence of its start
    std::uint64_t ended = 0;    ///< sequence of its end; 0: it still runs, or was interrupted
    SessionSample session;      ///< sample from its start
};

}  // namespace leitstand
