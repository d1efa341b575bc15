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

/// Inputs of a station's alarms. The functions are called on the alarms' own thread.
struct StationAlarmsSetup {
    std::vector<RobotDescription> robots;
    std::string station;  ///< persistent identity
    AlarmLimits limits = {};
    AlarmTiming timing = {};
    std::function<RobotView(const std::string& robot)> view;
    std::function<MissionStatePtr()> mission;
    std::function<LiveMapPtr()> scans;              ///< key scans of the map
    std::function<RobotsInMapPtr()> places = {};    ///< places of robots in the map
    std::function<void(const AlarmSample&)> onLog;  ///< logs the sample in the mission
};

/// All alarms as views show them.
struct AlarmsView {
    std::vector<Alarm> alarms;     ///< newest first; those that ended come last
    std::uint64_t attentions = 0;  ///< rises with each alarm that is to be announced once
    bool loud = false;             ///< an alarm with the severity Act is not acknowledged
    Time mutedUntil{};             ///< station's clock; the past: not muted
};

/// Judges five times a second what the operator has to know, on its own thread, whatever the window is doing.
/// Logs when alarms are raised, acknowledged and over, and ends those that an earlier session left standing.
/// Alarms of the log itself are raised by LiveMission, and only shown here. Any thread.
class StationAlarms : public EventSink {
public:
    explicit StationAlarms(StationAlarmsSetup setup);
    ~StationAlarms() override;

    void close() override;  ///< judges no more; the functions of the setup are no longer called
    void onEvent(const Event& event) override;  ///< takes bumps, which may be over when alarms are judged
    void acknowledge(const AlarmId& id);
    void acknowledgeNewest();
    void mute(std::chrono::nanoseconds time);  ///< for @p time from now on; 0: ends it
    [[nodiscard]] AlarmsView view() const;
    [[nodiscard]] const AlarmLimits& limits() const { return m_setup.limits; }

private:
    struct Bump {
        std::map<std::string, std::uint32_t> hits;  ///< by bumper
        std::string newest = {};
        std::optional<SteadyTime> at = {};
    };
    void run(const std::stop_token& stop);
    /// Clears alarms that were left standing by sessions before the one that began at event @p session.
    void endEarlier(const MissionState& mission, std::uint64_t session) const;
    [[nodiscard]] std::vector<AlarmCause> causes(const MissionState& mission, Time now) const;
    void addOfStation(const MissionState& mission, std::vector<AlarmCause>& causes) const;
    void log(const std::vector<AlarmChange>& changes, Time now) const;

    const StationAlarmsSetup m_setup;
    mutable std::mutex m_mutex;  ///< guards the next two; nothing else is called under it
    AlarmBook m_book;
    std::map<std::string, Bump> m_bumps;  ///< by robot
    std::jthread m_thread;                ///< last: joined first
};

}  // namespace leitstand
