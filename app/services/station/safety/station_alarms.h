#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/services/log/event_sink.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/robot_in_map.h"
#include "core/mission/state/mission_state.h"
#include "core/station/alarms/alarm_book.h"
#include "core/station/alarms/alarm_rules.h"

namespace leitstand {

struct AlarmSample;
struct Event;

/// What a station's alarms need. The functions are called on the alarms' own thread.
struct StationAlarmsSetup {
    std::vector<RobotDescription> robots;
    std::string station;  ///< persistent identity
    AlarmLimits limits = {};
    AlarmTiming timing = {};
    std::function<RobotView(const std::string& robot)> view;
    std::function<MissionStatePtr()> mission;
    std::function<LiveMapPtr()> scans;              ///< returns the key scans of the map
    std::function<RobotsInMapPtr()> places = {};    ///< returns the places of robots in the map
    std::function<void(const AlarmSample&)> onLog;  ///< logs the sample in the mission
};

/// All alarms as views show them.
struct AlarmsView {
    std::vector<Alarm> alarms;     ///< active ones first, each group newest first
    std::uint64_t attentions = 0;  ///< increases with each alarm that should be announced once
    bool loud = false;             ///< whether an alarm with the severity Act is not acknowledged
    Time mutedUntil{};             ///< station's clock; a time in the past: not muted
};

/// Finds out five times a second what the operator must know, on its own thread, whatever the window does.
/// Logs when alarms are raised, acknowledged and ended, and ends those that an earlier session left active.
/// Alarms of the log itself are raised by LiveMission, and are only shown here. Any thread.
class StationAlarms : public EventSink {
public:
    explicit StationAlarms(StationAlarmsSetup setup);
    ~StationAlarms() override;

    void close() override;  ///< stops; afterwards the functions of the setup are no longer called
    /// Takes bumps, since they may have ended when alarms are checked.
    void onEvent(const Event& event) override;
    void acknowledge(const AlarmId& id);
    void acknowledgeNewest();
    void mute(std::chrono::nanoseconds time);  ///< for @p time from now on; 0: no longer muted
    [[nodiscard]] AlarmsView view() const;
    [[nodiscard]] const AlarmLimits& limits() const { return m_setup.limits; }

private:
    struct Bump {
        std::map<std::string, std::uint32_t> hits;  ///< by bumper
        std::string newest = {};
        std::optional<SteadyTime> at = {};
    };
    void run(const std::stop_token& stop);
    /// Clears alarms that were left active by sessions before the one that began at event @p session.
    void endEarlier(const MissionState& mission, std::uint64_t session) const;
    [[nodiscard]] std::vector<AlarmCause> causes(const MissionState& mission, Time now) const;
    void addOfStation(const MissionState& mission, std::vector<AlarmCause>& causes) const;
    void log(const std::vector<AlarmChange>& changes, Time now) const;

    const StationAlarmsSetup m_setup;
    mutable std::mutex m_mutex;  ///< guards the next two members; nothing else is called while it is held
    AlarmBook m_book;
    std::map<std::string, Bump> m_bumps;  ///< by robot
    std::jthread m_thread;                ///< the last member, so that it is joined first
};

}  // namespace leitstand
