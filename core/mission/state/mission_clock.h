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

/// What the clock that was said last in @p said shows at @p now (station's clock); it stands at zero before
/// any. It goes on while no station runs: the arena's clock does not wait for a restart.
[[nodiscard]] MissionClock clockAt(const std::optional<ClockSample>& said, Time now);

/// Whether a station let it go as its mission began, and nobody has touched it since.
[[nodiscard]] bool beganByItself(const ClockSample& clock);

/// @p clock with a length of @p minutes where nobody gave it one; as it is with 0 minutes.
[[nodiscard]] MissionClock withLength(MissionClock clock, double minutes);

/// What a station says to make the clock that shows @p clock at @p now go or stand.
[[nodiscard]] ClockSample clockRun(const MissionClock& clock, bool running, Time now,
                                   const std::string& station);
/// To give it another length; negative lengths are none.
[[nodiscard]] ClockSample clockLimited(const MissionClock& clock, std::chrono::nanoseconds limit, Time now,
                                       const std::string& station);
/// To let it begin again at zero, as it goes or stands.
[[nodiscard]] ClockSample clockReset(const MissionClock& clock, Time now, const std::string& station);

}  // namespace leitstand
