#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/services/log/event_decoder.h"
#include "core/base/result.h"
#include "core/event/raw_event.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

class Sample;
struct Event;

/// Settings of a mission that is being recorded.
struct LiveMissionSettings {
    std::filesystem::path folder;  ///< created if absent; an existing one is resumed
    std::vector<RobotDescription>
        robots;  ///< their topics make up state(); their files are stored beside the log
    std::string station = "leitstand";  ///< persistent identity
    std::string title = "Leitstand";    ///< of the station, for people
    std::string version;                ///< of the program
    double alarmMinutes = 10.0;         ///< an alarm is raised when the disk lasts for less than this [min]
};

/// Status of a mission's log.
struct LiveMissionStatus {
    std::uint64_t events = 0, bytes = 0;  ///< committed in this session
    double bytesPerSecond = 0.0;          ///< over the last seconds
    double minutesLeft = 0.0;             ///< until the disk is full; infinite when nothing is written
    std::map<std::string, std::uint64_t> dropped;  ///< events per topic that will never be written
    std::map<std::string, DecodingErrors> broken;  ///< undecodable samples per topic; the log keeps them
    std::uint64_t lost = 0;                        ///< dropped events other than pictures
    std::string problem;                           ///< why nothing can be written; empty when all is well
};

/// Functions that are called on threads of the mission and must not block them.
struct LiveMissionListener {
    std::function<void(const std::string&)> onAlarm = {};  ///< in words: disk alarms, damage of the log
    /// Every decoded event, in the mission's order, once it is in the log and in state().
    std::function<void(const Event&)> onEvent = {};
};

/// The one ordered stream of events of a mission (docs/design.md, "A mission is its log"). Events that are
/// received or published are numbered, logged and applied to state(), in that order. Any thread.
class LiveMission {
public:
    using Listener = LiveMissionListener;

    /// Opens a new session of the mission. Errors name the folder.
    [[nodiscard]] static Result<std::unique_ptr<LiveMission>> open(const LiveMissionSettings& settings,
                                                                   Listener listener = {});
    ~LiveMission();  ///< as close()
    LiveMission(const LiveMission&) = delete;
    LiveMission& operator=(const LiveMission&) = delete;

    /// Announces @p topic, so that the log has its @p qos and the definition of its ROS @p type.
    void addTopic(const std::string& topic, const std::string& type, const Qos& qos);
    /// Takes a received event; never waits for the disk.
    void receive(RawEvent event);
    /// Publishes an event of the station itself on @p topic, one of station_topic. Error when @p sample
    /// contradicts itself, or when the mission is closed.
    Result<void> record(const Sample& sample, std::string_view topic);

    /// The newest state.
    [[nodiscard]] MissionStatePtr state() const;
    [[nodiscard]] LiveMissionStatus status() const;
    /// Waits until all published events are on the disk. Error when they cannot be written.
    Result<void> flush();
    /// Logs the end of the session and a last checkpoint, and makes the bag self-contained.
    Result<void> close();

private:
    struct AlarmRelay;
    struct State;
    explicit LiveMission(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
