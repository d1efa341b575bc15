#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "core/base/time.h"
#include "core/event/station_samples.h"

namespace leitstand {

/// The mission's clock at one moment.
struct MissionClock {
    bool running = false;
    std::chrono::nanoseconds elapsed{};                 ///< mission time
    std::chrono::nanoseconds limit{};                   ///< length of the mission; 0: none
    std::optional<std::chrono::nanoseconds> left = {};  ///< negative: over; empty without a limit
};

/// Returns what the clock shows at @p now (station's clock), by its newest sample @p reported; zero without a
/// sample. The clock runs on while no station runs, because the arena's clock does not wait for a restart.
[[nodiscard]] MissionClock clockAt(const std::optional<ClockSample>& reported, Time now);

/// Whether a station started the clock as its mission began and nobody has changed it since.
[[nodiscard]] bool beganByItself(const ClockSample& clock);

/// Returns @p clock with a length of @p minutes if it has no length yet; unchanged when @p minutes is 0.
[[nodiscard]] MissionClock withLength(MissionClock clock, double minutes);

/// Returns the sample that starts the clock, or stops it when @p running is false. @p clock: what it shows at
/// @p now.
[[nodiscard]] ClockSample clockRun(const MissionClock& clock, bool running, Time now,
                                   const std::string& station);
/// Returns the sample that sets the length of the mission to @p limit; 0 or less: none.
[[nodiscard]] ClockSample clockLimited(const MissionClock& clock, std::chrono::nanoseconds limit, Time now,
                                       const std::string& station);
/// Returns the sample that resets the clock to zero. The clock goes on running or stays stopped.
[[nodiscard]] ClockSample clockReset(const MissionClock& clock, Time now, const std::string& station);

}  // namespace leitstand
