#include "core/mission/state/mission_clock.h"

#include <algorithm>

namespace leitstand {
namespace {

ClockSample asPublished(const MissionClock& clock, Time now, const std::string& station) {
    ClockSample sample;
    sample.stamp = now;
    sample.station = station;
    sample.running = clock.running;
    sample.elapsed = clock.elapsed;
    sample.limit = clock.limit;
    return sample;
}

}  // namespace

MissionClock clockAt(const std::optional<ClockSample>& reported, Time now) {
    MissionClock clock;
    if (!reported) return clock;
    clock.running = reported->running;
    clock.limit = std::max(reported->limit, std::chrono::nanoseconds(0));
    clock.elapsed = reported->elapsed;
    // When a station's clock was set back, the elapsed time stays.
    if (clock.running) clock.elapsed += std::max(now - reported->stamp, std::chrono::nanoseconds(0));
    if (clock.limit.count() > 0) clock.left = clock.limit - clock.elapsed;
    return clock;
}

bool beganByItself(const ClockSample& clock) {
    return clock.running && clock.elapsed == std::chrono::nanoseconds(0) &&
           clock.limit == std::chrono::nanoseconds(0);
}

MissionClock withLength(MissionClock clock, double minutes) {
    if (clock.limit.count() > 0 || !(minutes > 0.0)) return clock;
    clock.limit = std::chrono::duration_cast<std::chrono::nanoseconds>(
        std::chrono::duration<double, std::ratio<60>>(minutes));
    clock.left = clock.limit - clock.elapsed;
    return clock;
}

ClockSample clockRun(const MissionClock& clock, bool running, Time now, const std::string& station) {
    ClockSample sample = asPublished(clock, now, station);
    sample.running = running;
    return sample;
}

ClockSample clockLimited(const MissionClock& clock, std::chrono::nanoseconds limit, Time now,
                         const std::string& station) {
    ClockSample sample = asPublished(clock, now, station);
    sample.limit = std::max(limit, std::chrono::nanoseconds(0));
    return sample;
}

ClockSample clockReset(const MissionClock& clock, Time now, const std::string& station) {
    ClockSample sample = asPublished(clock, now, station);
    sample.elapsed = std::chrono::nanoseconds(0);
    return sample;
}

}  // namespace leitstand
