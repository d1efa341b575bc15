#pragma once

#include <cstdint>

#include "core/event/station_samples.h"

namespace leitstand {

/// An alarm as it is now.
struct AlarmState {
    std::uint64_t sequence = 0;  ///< of the newest change
    std::uint64_t raised = 0;    ///< sequence of the newest raising
    std::uint64_t times = 0;     ///< how often it was raised
    AlarmSample alarm;
};

/// A period in which a station wrote the mission.
struct SessionState {
    std::uint64_t started = 0;  ///< sequence
    std::uint64_t ended = 0;    ///< sequence; 0: it runs, or was cut off
    SessionSample session;      ///< sample of its start
};

}  // namespace leitstand
