#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/mission/state/mission_clock.h"

namespace leitstand {

class LiveMission;

/// The mission's clock as this station sets it. Each change is an event of the mission. Any thread.
class StationClock {
public:
    using Changed = std::function<void(const ClockSample&)>;

    /// Starts the clock of a mission that has none yet. @p changed is called with the operator's changes.
    StationClock(LiveMission& mission, std::string station, Changed changed = {});

    [[nodiscard]] MissionClock now() const;
    Result<void> run(bool running);
    Result<void> limit(std::chrono::nanoseconds length);  ///< 0: no length
    Result<void> reset();

private:
    [[nodiscard]] MissionClock present() const;  ///< under the mutex
    template <class Change>
    Result<void> change(Change change);

    LiveMission& m_mission;
    const std::string m_station;
    Changed m_changed;
    mutable std::mutex m_mutex;  ///< makes sure that changes are made one after another
    /// Newest change by this station, under the mutex; may not be in the state yet.
    std::optional<ClockSample> m_recorded;
};

}  // namespace leitstand
