#include "app/services/log/live_mission.h"

#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "app/services/interrupt.h"
#include "app/services/log/mission_robots.h"
#include "app/services/log/replay/bag_history.h"
#include "app/services/log/sequencer.h"
#include "core/event/station_samples.h"
#include "core/event/station_topics.h"
#include "core/io/bag/bag_reader.h"
#include "core/io/bag/bag_writer.h"
#include "core/mission/state/fold.h"
#include "core/robot/streams/stream_table.h"
#include "core/station/alarms/log_format.h"
#include "core/station/alarms/logged_alarm.h"
#include "transport/convert/encode.h"
#include "transport/convert/message_catalog.h"

namespace leitstand {
namespace {

/// Returns the folder's own name, also when its path ends with a slash.
std::string nameOf(const std::filesystem::path& folder) {
    const auto whole = std::filesystem::absolute(folder).lexically_normal();
    return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

/// The key of an alarm in the mission's state.
std::string keyOf(BagAlarm::Kind kind) {
    switch (kind) {
        case BagAlarm::Kind::DiskFilling:
            return log_key::DiskFilling;
        case BagAlarm::Kind::DiskSlow:
            return log_key::DiskSlow;
        case BagAlarm::Kind::DiskFull:
            return log_key::DiskFull;
        case BagAlarm::Kind::EventsLost:
            return log_key::EventsLost;
        case BagAlarm::Kind::Failed:
            return log_key::Failed;
    }
    return {};
}

Qos stationQos() {
    return {
        .reliability = Qos::Reliability::Reliable, .durability = Qos::Durability::TransientLocal, .depth = 0};
}

/// Returns the state at the end of the earlier sessions of @p folder; reports to @p notify what cannot be
/// read.
MissionState earlierState(const std::filesystem::path& folder, EventDecoder& decoder,
                          const std::function<void(const std::string&)>& notify) {
    const auto bag = BagReader::open(folder);
    if (!bag) return {};
    decoder.setDepths(false);
    BagHistory history(**bag, decoder);
    MissionState state = stateAt(history, (*bag)->lastSequence());
    for (const std::string& problem : (*bag)->problems()) {
        if (notify) notify(problem);
    }
    return state;
}

}  // namespace

/// Passes alarms of the disk to the mission once there is one: the writer's threads begin earlier.
struct LiveMission::AlarmRelay {
    std::mutex mutex;
    State* state = nullptr;

    void raise(const BagAlarm& alarm);
};

struct LiveMission::State {
    LiveMissionSettings settings;
    const std::function<void(const Event&)> onEvent;
    EventDecoder decoder;  ///< used by the sequencer's thread only
    Fold fold;             ///< used by the sequencer's thread only
    std::shared_ptr<AlarmRelay> relay;
    std::unique_ptr<BagWriter> bag;
    mutable std::mutex mutex;                      ///< guards the next three
    std::map<std::string, bool> announced;         ///< topics; whether they carry pictures
    MissionStatePtr snapshot;                      ///< newest state
    std::map<std::string, DecodingErrors> broken;  ///< errors of the decoder
    std::atomic<bool> ending = false;              ///< the next session event is the session's end
    std::mutex taking;                             ///< held while an event from outside is numbered
    std::unique_ptr<Sequencer> sequencer;          ///< last but one: ends first
    std::optional<WhenLate> rescue;                ///< closes the log of a process that hangs

    State(LiveMissionSettings chosen, MissionState earlier, std::shared_ptr<AlarmRelay> alarms,
          std::unique_ptr<BagWriter> writer, std::function<void(const Event&)> onRecorded)
        : settings(std::move(chosen)),
          onEvent(std::move(onRecorded)),
          decoder(settings.robots),
          fold(std::move(earlier)),
          relay(std::move(alarms)),
          bag(std::move(writer)) {
        snapshot = fold.snapshot();
        sequencer = std::make_unique<Sequencer>(bag->earlierSequence(),
                                                [this](const RawEvent& event) { take(event); });
        const std::lock_guard lock(relay->mutex);
        relay->state = this;
    }
    ~State() {
        const std::lock_guard lock(relay->mutex);
        relay->state = nullptr;
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    void announce(const std::string& topic, const std::string& type, const Qos& qos);
    void take(const RawEvent& event);
    void addCheckpoint(Time now, std::chrono::nanoseconds interval);
    Result<void> record(const Sample& sample, std::string_view topic);
    [[nodiscard]] SessionSample session(bool start) const;
};

void LiveMission::State::announce(const std::string& topic, const std::string& type, const Qos& qos) {
    // Locked to the end: a caller that finds the topic announced may write on it at once.
    const std::lock_guard lock(mutex);
    if (!announced.emplace(topic, isPictureType(type)).second) return;
    TopicInfo info;
    info.name = topic;
    info.type = type;
    info.qosProfiles = qosProfilesOf(qos);
    info.droppable = isPictureType(type);  // what a slow disk drops first
    info.urgent = station_topic::isByHand(topic);
    if (const MessageType* known = findMessageType(type)) {
        info.definition = known->definition;
        info.typeHash = known->hash;
    }
    bag->addTopic(info);
}

void LiveMission::State::take(const RawEvent& event) {
    bag->write(event);
    std::vector<Event> understood;
    decoder.decode(event, [&](const Event& decoded) {
        fold.add(decoded);
        if (onEvent) understood.push_back(decoded);
    });
    const bool last = ending && event.topic == station_topic::Sessions;
    addCheckpoint(event.received, std::chrono::seconds(last ? 0 : 20));
    {
        const std::lock_guard lock(mutex);
        snapshot = fold.snapshot();
        if (!decoder.errors().empty()) broken = decoder.errors();
    }
    for (const Event& one : understood) onEvent(one);
}

void LiveMission::State::addCheckpoint(Time now, std::chrono::nanoseconds interval) {
    if (const auto checkpoint = fold.dueCheckpoint(now, interval)) {
        (void)record(*checkpoint, station_topic::Checkpoints);  // a checkpoint can always be encoded
    }
}

Result<void> LiveMission::State::record(const Sample& sample, std::string_view topic) {
    const std::string type(typeOf(sample));
    auto payload = encode(sample, type);
    if (!payload) return payload.error();
    announce(std::string(topic), type, stationQos());
    sequencer->push({.topic = std::string(topic), .type = type, .cdr = std::move(payload).value()});
    return {};
}

void LiveMission::AlarmRelay::raise(const BagAlarm& alarm) {
    const std::lock_guard lock(mutex);
    // A log that is being closed takes no more events, and the alarms would count as lost.
    if (state == nullptr || state->ending) return;
    const bool filling = alarm.kind == BagAlarm::Kind::DiskFilling || alarm.kind == BagAlarm::Kind::DiskSlow;
    const AlarmSample sample{
        .stamp = stationTime(),
        .station = state->settings.station,
        .robot = {},
        .key = keyOf(alarm.kind),
        .severity = filling ? AlarmSample::Severity::Warning : AlarmSample::Severity::Critical,
        .state = alarm.raised ? AlarmSample::State::Raised : AlarmSample::State::Cleared,
        .text = alarm.text};
    (void)state->record(sample, station_topic::Alarms);  // the log has room for it once the disk has
}

SessionSample LiveMission::State::session(bool start) const {
    return {.stamp = stationTime(),
            .station = settings.station,
            .title = settings.title,
            .start = start,
            .mission = nameOf(settings.folder),
            .version = settings.version};
}

Result<std::unique_ptr<LiveMission>> LiveMission::open(const LiveMissionSettings& settings,
                                                       Listener listener) {
    EventDecoder decoder(settings.robots);
    std::error_code ignored;
    MissionState earlier;
    if (std::filesystem::exists(settings.folder, ignored))
        earlier = earlierState(settings.folder, decoder, listener.onAlarm);
    BagWriterSettings log;
    log.storage = settings.storage;
    log.alarmMinutes = settings.alarmMinutes;
    auto relay = std::make_shared<AlarmRelay>();
    auto bag = BagWriter::open(settings.folder, log,
                               [relay, onAlarm = std::move(listener.onAlarm)](const BagAlarm& alarm) {
                                   relay->raise(alarm);
                                   if (onAlarm) onAlarm(log_format::message(alarm.text));
                               });
    if (!bag) return bag.error();
    if (const auto kept = keepRobots(settings.folder, settings.robots); !kept) return kept.error();
    auto state = std::make_unique<State>(settings, std::move(earlier), std::move(relay),
                                         std::move(bag).value(), std::move(listener.onEvent));
    if (const auto recorded = state->record(state->session(true), station_topic::Sessions); !recorded)
        return recorded.error();
    std::unique_ptr<LiveMission> mission(new LiveMission(std::move(state)));
    mission->m_state->rescue.emplace([raw = mission.get()] { (void)raw->close(); });
    return mission;
}

LiveMission::LiveMission(std::unique_ptr<State> state) : m_state(std::move(state)) {}

LiveMission::~LiveMission() {
    m_state->rescue.reset();
    (void)close();
}

void LiveMission::addTopic(const std::string& topic, const std::string& type, const Qos& qos) {
    m_state->announce(topic, type, qos);
}

void LiveMission::receive(RawEvent event) {
    const std::lock_guard lock(m_state->taking);
    if (!m_state->ending) m_state->sequencer->push(std::move(event));
}

Result<void> LiveMission::record(const Sample& sample, std::string_view topic) {
    const std::lock_guard lock(m_state->taking);
    if (m_state->ending) return Error{m_state->settings.folder.string() + ": is closed"};
    return m_state->record(sample, topic);
}

MissionStatePtr LiveMission::state() const {
    const std::lock_guard lock(m_state->mutex);
    return m_state->snapshot;
}

LiveMissionStatus LiveMission::status() const {
    const BagWriterStatistics bag = m_state->bag->statistics();
    const std::lock_guard lock(m_state->mutex);
    std::uint64_t lost = 0;
    for (const auto& [topic, count] : bag.dropped) {
        const auto known = m_state->announced.find(topic);
        if (known == m_state->announced.end() || !known->second) lost += count;
    }
    return {.events = bag.writtenEvents,
            .bytes = bag.writtenBytes,
            .bytesPerSecond = bag.bytesPerSecond,
            .minutesLeft = bag.minutesLeft,
            .dropped = bag.dropped,
            .broken = m_state->broken,
            .lost = lost,
            .problem = bag.problem};
}

Result<void> LiveMission::flush() {
    m_state->sequencer->drain();
    return m_state->bag->flush();
}

Result<void> LiveMission::close() {
    {
        const std::lock_guard lock(m_state->taking);
        if (m_state->ending.exchange(true)) return {};
    }
    const auto recorded = m_state->record(m_state->session(false), station_topic::Sessions);
    m_state->sequencer->drain();  // the end of the session, which causes the last checkpoint
    m_state->sequencer->drain();
    const auto written = m_state->bag->close();
    return !recorded ? recorded : written;
}

}  // namespace leitstand
