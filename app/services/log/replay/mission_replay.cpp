#include "app/services/log/replay/mission_replay.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <set>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "app/services/domain/topic_lane.h"
#include "app/services/log/replay/replay_pace.h"
#include "app/services/log/replay/replay_rules.h"
#include "core/io/bag/bag_reader.h"
#include "core/robot/streams/stream_table.h"
#include "transport/dds/node.h"
#include "transport/domain/join_settings.h"

namespace leitstand {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds Tick(20);  ///< how soon a pause or a cancel is noticed

/// A reliable writer suits every reader; topics that were transient local are so again.
Qos offered(const TopicInfo& topic) {
    const bool stays = topic.qosProfiles.find("durability: 1") != std::string::npos ||
                       topic.qosProfiles.find("transient_local") != std::string::npos;
    Qos qos{.reliability = Qos::Reliability::Reliable,
            .durability = stays ? Qos::Durability::TransientLocal : Qos::Durability::Volatile,
            .depth = 100};
    if (laneOf(topic.type) == Lane::Large) qos.depth = topic.type.ends_with("Image") ? 10 : 600;
    return qos;
}

/// Whether robots share @p topic, so that two on it do not disturb each other.
bool isShared(const std::string& topic) {
    const auto table = streamTable();
    return std::any_of(table.begin(), table.end(), [&topic](const StreamFacts& row) {
        return row.shared && (row.topic == topic || "/" + std::string(row.topic) == topic);
    });
}

/// Returns the first live robot whose name is one of @p names; empty when there is none.
std::optional<std::string> liveNamesake(const Node& node, const std::set<std::string>& names) {
    for (const RemoteEndpoint& endpoint : node.endpoints()) {
        if (endpoint.kind != RemoteEndpoint::Kind::Writer) continue;
        const std::string robot = robotOfTopic(endpoint.topic);
        if (names.contains(robot) && isReplayable(endpoint.topic, endpoint.type)) return robot;
    }
    return std::nullopt;
}

}  // namespace

struct MissionReplay::State {
    ReplaySettings settings;
    std::unique_ptr<BagReader> bag;
    std::unique_ptr<Node> node;
    std::map<std::pair<std::string, std::string>, std::unique_ptr<Publisher>> publishers;  ///< by topic, type
    std::set<std::string> robots, heldBack;
    std::set<std::string> unnamed;  ///< topics without a robot's name: "/odom"
    ReplayOutcome outcome;

    bool waitUntil(Clock::time_point& due, const std::atomic<bool>& paused, const Progress& progress);
    void publish(const RawEvent& event);
    void waitForListeners(const Progress& progress) const;
    bool playOnce(const std::atomic<bool>& paused, const Progress& progress);
};

Result<std::unique_ptr<MissionReplay>> MissionReplay::open(const ReplaySettings& settings,
                                                           const Progress& progress) {
    auto bag = BagReader::open(settings.mission);
    if (!bag) return bag.error();
    auto state = std::make_unique<State>();
    state->settings = settings;
    state->bag = std::move(bag).value();
    for (const BagTopic& topic : state->bag->topics()) {
        if (!isReplayable(topic.info.name, topic.info.type)) {
            state->heldBack.insert(topic.info.name);
        } else if (const std::string robot = robotOfTopic(topic.info.name); !robot.empty()) {
            state->robots.insert(robot);
        } else if (!isShared(topic.info.name)) {
            state->unnamed.insert(topic.info.name);
        }
    }
    auto chosen = nodeSettings(settings.domain, "leitstandctl replay");
    if (!chosen) return chosen.error();
    NodeSettings network = std::move(chosen).value();
    // There is no radio to spare: at several times its speed, a mission must not wait in our own queues.
    network.telemetryLimit = network.scanLimit = network.pictureLimit = {8000, 1};
    auto node = Node::create(network);
    if (!node) return node.error();
    state->node = std::move(node).value();
    // Discovery takes its time: nothing is published before it is clear that no robot of that name is there.
    const auto settled = Clock::now() + std::chrono::duration<double>(settings.settleSeconds);
    do {
        if (const auto robot = liveNamesake(*state->node, state->robots)) {
            return Error{fmt::format("domain {}: robot {} is there live; replay on another domain (--domain)",
                                     settings.domain.domain, *robot)};
        }
        for (const RemoteEndpoint& endpoint : state->node->endpoints()) {
            if (endpoint.kind != RemoteEndpoint::Kind::Writer || !state->unnamed.contains(endpoint.topic))
                continue;
            return Error{fmt::format("domain {}: {} is there live; replay on another domain (--domain)",
                                     settings.domain.domain, endpoint.topic)};
        }
        std::this_thread::sleep_for(Tick);
    } while (Clock::now() < settled && !progress.cancelled());
    for (const BagTopic& topic : state->bag->topics()) {
        if (state->heldBack.contains(topic.info.name)) continue;
        auto publisher = state->node->publisher({.topic = topic.info.name,
                                                 .type = topic.info.type,
                                                 .qos = offered(topic.info),
                                                 .flow = flowOf(topic.info.type)});
        if (!publisher) {  // DDS knows one type per topic
            state->outcome.problems.push_back(publisher.error().text);
            continue;
        }
        state->publishers.emplace(std::pair(topic.info.name, topic.info.type), std::move(publisher).value());
    }
    return std::unique_ptr<MissionReplay>(new MissionReplay(std::move(state)));
}

MissionReplay::MissionReplay(std::unique_ptr<State> state) : m_state(std::move(state)) {}
MissionReplay::~MissionReplay() = default;

/// Waits for @p due, which moves on by the length of pauses; false when the replay was cancelled.
bool MissionReplay::State::waitUntil(Clock::time_point& due, const std::atomic<bool>& paused,
                                     const Progress& progress) {
    while (!progress.cancelled()) {
        const auto now = Clock::now();
        if (paused) {
            std::this_thread::sleep_for(Tick);
            due += Clock::now() - now;
            continue;
        }
        if (now >= due) return true;
        std::this_thread::sleep_until(std::min(due, now + Tick));
    }
    return false;
}

void MissionReplay::State::publish(const RawEvent& event) {
    const auto publisher = publishers.find({event.topic, event.type});
    if (publisher == publishers.end()) {
        ++outcome.heldBack;
        return;
    }
    if (const auto written = publisher->second->write(event.cdr)) {
        ++outcome.published;
    } else if (outcome.problems.size() < 100) {
        outcome.problems.push_back(written.error().text);
    }
}

bool MissionReplay::State::playOnce(const std::atomic<bool>& paused, const Progress& progress) {
    BagCursor cursor = bag->read();
    const auto events = static_cast<double>(std::max<std::uint64_t>(bag->lastSequence(), 1));
    auto due = Clock::now();
    ReplayPace pace;
    auto session = bag->sessions().begin();
    while (const auto event = cursor.next()) {
        bool begins = false;
        for (; session != bag->sessions().end() && event->sequence > session->lastSequence; ++session)
            begins = true;
        const std::chrono::duration<double> wait = pace.waitBefore(event->received, begins);
        due += std::chrono::duration_cast<Clock::duration>(wait / settings.rate);
        if (!waitUntil(due, paused, progress)) return false;  // pauses delay everything
        publish(*event);
        progress.done(static_cast<double>(event->sequence) / events);
    }
    return true;
}

/// Waits until the last samples have reached those that still listen.
void MissionReplay::State::waitForListeners(const Progress& progress) const {
    const auto until = Clock::now() + std::chrono::seconds(30);
    for (const auto& [key, publisher] : publishers) {
        while (!publisher->waitForAcknowledgments(std::chrono::milliseconds(100))) {
            if (progress.cancelled() || Clock::now() > until) return;
        }
    }
}

ReplayOutcome MissionReplay::play(const std::atomic<bool>& paused, const Progress& progress) {
    // A mission without anything to publish must not be played over and over.
    while (m_state->playOnce(paused, progress) && m_state->settings.loop && m_state->outcome.published > 0 &&
           !progress.cancelled()) {
    }
    m_state->waitForListeners(progress);
    ReplayOutcome& outcome = m_state->outcome;
    outcome.heldBackTopics.assign(m_state->heldBack.begin(), m_state->heldBack.end());
    const auto& problems = m_state->bag->problems();
    outcome.problems.insert(outcome.problems.end(), problems.begin(), problems.end());
    return outcome;
}

}  // namespace leitstand
