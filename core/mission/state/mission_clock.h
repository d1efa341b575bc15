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

/// Returns what the clock shows at @p now (station's clock), by the newest sample @p reported; zero without
/// one. It runs on while no station runs, because the arena's clock does not wait for a restart.
[[nodiscard]] MissionClock clockAt(const std::optional<ClockSample>& reported, Time now);

/// Whether a station started the clock as its mission began and nobody has changed it since.
[[nodiscard]] bool beganByItself(const ClockSample& clock);

/// Returns @p clock with a length of @p minutes when it has none; unchanged for 0 minutes.
[[nodiscard]] MissionClock withLength(MissionClock clock, double minutes);

/// Returns the sample that starts or stops the clock, which shows @p clock at @p now.
[[nodiscard]] ClockSample clockRun(const MissionClock& clock, bool running, Time now,
                                   const std::string& station);
/// Returns the sample that changes its length; negative lengths mean none.
[[nodiscard]] ClockSample clockLimited(const MissionClock& clock, std::chrono::nanoseconds limit, Time now,
                                       const std::string& station);
/// Returns the sample that resets it to zero, running or stopped as it is.
[[nodiscard]] ClockSample clockReset(const MissionClock& clock, Time now, const std::string& station);

}  // namespace leitstand
