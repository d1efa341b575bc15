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
#include "core/event/event.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

/// A mission that is being recorded.
struct LiveMissionSettings {
    std::filesystem::path folder;          ///< made where it is absent; one that exists is resumed
    std::vector<RobotDescription> robots;  ///< whose topics are folded; kept in the folder with the log
    std::string station = "leitstand";     ///< persistent identity
    std::string title = "Leitstand";       ///< of the station, for people
    std::string version;                   ///< of the program
    double alarmMinutes = 10.0;            ///< an alarm is raised when the disk lasts shorter than this [min]
};

/// How the log of a mission is doing.
struct LiveMissionStatus {
    std::uint64_t events = 0, bytes = 0;  ///< committed in this session
    double bytesPerSecond = 0.0;          ///< over the last seconds
    double minutesLeft = 0.0;             ///< until the disk is full; infinite when nothing is written
    std::map<std::string, std::uint64_t> dropped;  ///< events a topic that will never be written
    std::map<std::string, DecodingErrors> broken;  ///< samples a topic that make no sense (kept all the same)
    std::uint64_t lost = 0;                        ///< of the dropped: events other than pictures
    std::string problem;                           ///< why nothing can be written; empty when all is well
};

/// Called on threads of the mission's, which they must not hold up.
struct LiveMissionListener {
    std::function<void(const std::string&)> onAlarm = {};  ///< the disk, in words
    /// Everything that could be decoded, in the mission's order, once it is in the log and in state().
    std::function<void(const Event&)> onEvent = {};
};

/// The one ordered stream of events of a mission (design, section 1): what is received or said is numbered,
/// logged and folded, in that order. Any thread.
class LiveMission {
public:
    using Listener = LiveMissionListener;

    /// Opens a new session of the mission. Errors name the folder.
    [[nodiscard]] static Result<std::unique_ptr<LiveMission>> open(const LiveMissionSettings& settings,
                                                                   Listener listener = {});
    ~LiveMission();  ///< as close()
    LiveMission(const LiveMission&) = delete;
    LiveMission& operator=(const LiveMission&) = delete;

    /// Announces a topic, so that the log tells its QoS and definition; @p type is its ROS name.
    void addTopic(const std::string& topic, const std::string& type, const Qos& qos);
    /// Takes what came over the wire; never waits for the disk.
    void receive(RawEvent event);
    /// Takes an event of the station's own, on one of station_topic. An error when it contradicts itself.
    Result<void> say(const Sample& sample, std::string_view topic);

    /// The newest state.
    [[nodiscard]] MissionStatePtr state() const;
    [[nodiscard]] LiveMissionStatus status() const;
    /// Waits until all that was said is on the disk. Errors: it cannot be written.
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
