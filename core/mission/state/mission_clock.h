#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "core/base/time.h"
#include "core/event/station_samples.h"

namespace leitstand {

/// What the mission's clock shows at one moment.
struct MissionClock {
    bool running = false;
    std::chrono::nanoseconds elapsed{};  ///< mission time
    std::chrono::nanoseconds limit{};    ///< length of the mission; 0: not set
    /// Negative: the mission is over; empty: no length is set.
    std::optional<std::chrono::nanoseconds> left = {};
};

/// Returns what the clock shows at @p now (station's clock), from its newest sample @p reported; zero without
/// a sample. The clock continues while no station runs, because the arena's clock does not wait for a
/// restart.
[[nodiscard]] MissionClock clockAt(const std::optional<ClockSample>& reported, Time now);

/// Whether a station started the clock when its mission began, and nobody has changed it since.
[[nodiscard]] bool beganByItself(const ClockSample& clock);

/// Returns @p clock with a length of @p minutes if it has no length yet. It is not changed when @p minutes is
/// 0.
[[nodiscard]] MissionClock withLength(MissionClock clock, double minutes);

/// Returns the sample that starts the clock, or stops it when @p running is false. @p clock: what the clock
/// shows at @p now.
[[nodiscard]] ClockSample clockRun(const MissionClock& clock, bool running, Time now,
                                   const std::string& station);
/// Returns the sample that sets the length of the mission to @p limit; 0 or less: no length.
[[nodiscard]] ClockSample clockLimited(const MissionClock& clock, std::chrono::nanoseconds limit, Time now,
                                       const std::string& station);
/// Returns the sample that resets the clock to zero. It does not start or stop the clock.
[[nodiscard]] ClockSample clockReset(const MissionClock& clock, Time now, const std::string& station);

}  // namespace leitstand
