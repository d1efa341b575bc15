#include "app/session/log/live_mission.h"

#include <mutex>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "app/session/log/bag_history.h"
#include "app/session/log/mission_robots.h"
#include "app/session/log/sequencer.h"
#include "core/io/bag/bag_reader.h"
#include "core/io/bag/bag_writer.h"
#include "core/mission/fold.h"
#include "core/mission/station_topics.h"
#include "transport/convert/encode.h"
#include "transport/convert/message_catalog.h"

namespace leitstand {
namespace {

/// What a slow disk costs first.
bool isPicture(const std::string& type) {
    return type == "sensor_msgs/msg/Image" || type == "sensor_msgs/msg/CompressedImage";
}

Qos stationQos() {
    return {
        .reliability = Qos::Reliability::Reliable, .durability = Qos::Durability::TransientLocal, .depth = 0};
}

/// The state at the end of the earlier sessions of @p folder.
MissionState earlierState(const std::filesystem::path& folder, EventDecoder& decoder) {
    const auto bag = BagReader::open(folder);
    if (!bag) return {};
    BagHistory history(**bag, decoder);
    return stateAt(history, (*bag)->lastSequence());
}

}  // namespace

struct LiveMission::State {
    LiveMissionSettings settings;
    EventDecoder decoder;  ///< used by the sequencer's thread alone
    Fold fold;             ///< likewise
    std::unique_ptr<BagWriter> bag;
    mutable std::mutex mutex;                      ///< of the next three
    std::set<std::string> announced;               ///< topics
    MissionStatePtr snapshot;                      ///< newest state
    std::map<std::string, DecodingErrors> broken;  ///< of the decoder
    bool closed = false;
    std::unique_ptr<Sequencer> sequencer;  ///< last: ends first

    State(LiveMissionSettings chosen, MissionState earlier, std::unique_ptr<BagWriter> writer)
        : settings(std::move(chosen)),
          decoder(settings.robots),
          fold(std::move(earlier)),
          bag(std::move(writer)) {
        snapshot = fold.snapshot();
        sequencer = std::make_unique<Sequencer>(bag->earlierSequence(),
                                                [this](const RawEvent& event) { take(event); });
    }

    void announce(const std::string& topic, const std::string& type, const Qos& qos);
    void take(const RawEvent& event);
    void addCheckpoint(Time now, std::chrono::nanoseconds interval);
    Result<void> say(const Sample& sample, std::string_view topic);
    [[nodiscard]] SessionSample session(bool start) const;
};

void LiveMission::State::announce(const std::string& topic, const std::string& type, const Qos& qos) {
    {
        const std::lock_guard lock(mutex);
        if (!announced.insert(topic).second) return;
    }
    TopicInfo info;
    info.name = topic;
    info.type = type;
    info.qosProfiles = qosProfilesOf(qos);
    info.droppable = isPicture(type);
    if (const MessageType* known = findMessageType(type)) {
        info.definition = known->definition;
        info.typeHash = known->hash;
    }
    bag->addTopic(info);
}

void LiveMission::State::take(const RawEvent& event) {
    bag->write(event);
    decoder.decode(event, [this](const Event& decoded) { fold.add(decoded); });
    addCheckpoint(event.received, std::chrono::seconds(20));
    const std::lock_guard lock(mutex);
    snapshot = fold.snapshot();
    if (!decoder.errors().empty()) broken = decoder.errors();
}

void LiveMission::State::addCheckpoint(Time now, std::chrono::nanoseconds interval) {
    if (const auto checkpoint = fold.dueCheckpoint(now, interval)) {
        (void)say(*checkpoint, station_topic::Checkpoints);  // what serialises itself can be encoded
    }
}

Result<void> LiveMission::State::say(const Sample& sample, std::string_view topic) {
    const std::string type(typeOf(sample));
    auto payload = encode(sample, type);
    if (!payload) return payload.error();
    announce(std::string(topic), type, stationQos());
    sequencer->push({.topic = std::string(topic), .type = type, .cdr = std::move(payload).value()});
    return {};
}

SessionSample LiveMission::State::session(bool start) const {
    return {.stamp = stationTime(),
            .station = settings.station,
            .title = settings.title,
            .start = start,
            .mission = settings.folder.filename().string(),
            .version = settings.version};
}

Result<std::unique_ptr<LiveMission>> LiveMission::open(const LiveMissionSettings& settings,
                                                       Listener listener) {
    EventDecoder decoder(settings.robots);
    std::error_code ignored;
    MissionState earlier;
    if (std::filesystem::exists(settings.folder, ignored)) earlier = earlierState(settings.folder, decoder);
    auto bag =
        BagWriter::open(settings.folder, {}, [onAlarm = std::move(listener.onAlarm)](const BagAlarm& alarm) {
            if (onAlarm) onAlarm(alarm.text);
        });
    if (!bag) return bag.error();
    if (const auto kept = keepRobots(settings.folder, settings.robots); !kept) return kept.error();
    auto state = std::make_unique<State>(settings, std::move(earlier), std::move(bag).value());
    if (const auto said = state->say(state->session(true), station_topic::Sessions); !said)
        return said.error();
    return std::unique_ptr<LiveMission>(new LiveMission(std::move(state)));
}

LiveMission::LiveMission(std::unique_ptr<State> state) : m_state(std::move(state)) {}

LiveMission::~LiveMission() {
    (void)close();
}

void LiveMission::addTopic(const std::string& topic, const std::string& type, const Qos& qos) {
    m_state->announce(topic, type, qos);
}

void LiveMission::receive(RawEvent event) {
    m_state->sequencer->push(std::move(event));
}

Result<void> LiveMission::say(const Sample& sample, std::string_view topic) {
    return m_state->say(sample, topic);
}

MissionStatePtr LiveMission::state() const {
    const std::lock_guard lock(m_state->mutex);
    return m_state->snapshot;
}

LiveMissionStatus LiveMission::status() const {
    const BagWriterStatistics bag = m_state->bag->statistics();
    const std::lock_guard lock(m_state->mutex);
    return {.events = bag.writtenEvents,
            .bytes = bag.writtenBytes,
            .bytesPerSecond = bag.bytesPerSecond,
            .minutesLeft = bag.minutesLeft,
            .dropped = bag.dropped,
            .broken = m_state->broken,
            .problem = bag.problem};
}

Result<void> LiveMission::close() {
    if (std::exchange(m_state->closed, true)) return {};
    const auto said = m_state->say(m_state->session(false), station_topic::Sessions);
    m_state->sequencer->drain();
    m_state->addCheckpoint(stationTime(), std::chrono::nanoseconds(0));
    m_state->sequencer->drain();
    const auto written = m_state->bag->close();
    return !said ? said : written;
}

}  // namespace leitstand
