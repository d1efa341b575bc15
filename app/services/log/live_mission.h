#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/services/log/event_decoder.h"
#include "core/base/result.h"
#include "core/event/raw_event.h"
#include "core/io/bag/bag_storage.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

class Sample;
struct Event;

/// Settings of a mission that is being recorded.
struct LiveMissionSettings {
    std::filesystem::path folder;         ///< made if it is missing; an existing mission is resumed
    std::optional<BagStorage> storage{};  ///< see BagWriterSettings::storage
    std::vector<RobotDescription>
        robots;  ///< robots whose topics are used for state(); their files are stored beside the log
    std::string station = "leitstand";  ///< persistent identity
    std::string title = "Leitstand";    ///< name of the station for people
    std::string version;                ///< version of the program
    double alarmMinutes = 10.0;  ///< an alarm is raised if the disk will be full within this time [min]
};

/// Status of a mission's log.
struct LiveMissionStatus {
    std::uint64_t events = 0, bytes = 0;  ///< committed in this session: events and bytes
    double bytesPerSecond = 0.0;          ///< mean over the last seconds
    double minutesLeft = 0.0;             ///< time until the disk is full; infinite when nothing is written
    std::map<std::string, std::uint64_t> dropped;  ///< number of events that will never be written, by topic
    /// Samples that cannot be decoded, by topic; the log has them.
    std::map<std::string, DecodingErrors> broken;
    std::uint64_t lost = 0;  ///< number of dropped events, without pictures
    std::string problem;     ///< why nothing can be written; empty: there is no problem
};

/// Functions that are called on threads of the mission and must not block them.
struct LiveMissionListener {
    /// Called with a text: disk alarms, damage of the log.
    std::function<void(const std::string&)> onAlarm = {};
    /// Called with every decoded event, in the mission's order, after it was added to the log and to state().
    std::function<void(const Event&)> onEvent = {};
};

/// The single ordered sequence of events of a mission (docs/design.md, "A mission is its log"). Events that
/// are received or published are numbered, logged and applied to state(), in that order. Any thread.
class LiveMission {
public:
    using Listener = LiveMissionListener;

    /// Opens a new session of the mission. Errors name the folder.
    [[nodiscard]] static Result<std::unique_ptr<LiveMission>> open(const LiveMissionSettings& settings,
                                                                   Listener listener = {});
    ~LiveMission();  ///< does the same as close()
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
