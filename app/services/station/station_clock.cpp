#include "app/services/station/station_clock.h"

#include <optional>
#include <utility>

#include "app/services/log/live_mission.h"
#include "app/services/log/sequencer.h"
#include "core/event/station_topics.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

StationClock::StationClock(LiveMission& mission, std::string station, Changed changed)
    : m_mission(mission), m_station(std::move(station)) {
    if (!mission.state()->clock) (void)run(true);  // the log reports what is wrong with it
    m_recorded.reset();                            // the team's clock takes precedence
    m_changed = std::move(changed);                // others need no notice that it began by itself
}

MissionClock StationClock::now() const {
    const std::lock_guard lock(m_mutex);
    return present();
}

MissionClock StationClock::present() const {
    std::optional<ClockSample> newest = m_recorded;
    if (const auto folded = m_mission.state()->clock;
        folded && (!newest || newest->stamp < folded->sample.stamp))
        newest = folded->sample;
    return clockAt(newest, stationTime());
}

template <class Change>
Result<void> StationClock::change(Change change) {
    const std::lock_guard lock(m_mutex);
    const ClockSample sample = change(present(), stationTime(), m_station);
    auto recorded = m_mission.record(sample, station_topic::Clock);
    if (recorded) m_recorded = sample;
    if (recorded && m_changed) m_changed(sample);
    return recorded;
}

Result<void> StationClock::run(bool running) {
    return change([running](const MissionClock& clock, Time at, const std::string& station) {
        return clockRun(clock, running, at, station);
    });
}

Result<void> StationClock::limit(std::chrono::nanoseconds length) {
    return change([length](const MissionClock& clock, Time at, const std::string& station) {
        return clockLimited(clock, length, at, station);
    });
}

Result<void> StationClock::reset() {
    return change(clockReset);
}

}  // namespace leitstand
