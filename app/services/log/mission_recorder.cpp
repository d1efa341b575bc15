#include "app/services/log/mission_recorder.h"

#include <condition_variable>
#include <map>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

#include "app/services/domain/reception_watch.h"
#include "app/services/log/link_line.h"
#include "core/event/sample.h"
#include "core/event/station_samples.h"
#include "core/event/station_topics.h"
#include "transport/dds/node.h"
#include "transport/domain/join_settings.h"
#include "transport/link/link_client.h"

namespace leitstand {
namespace {

/// Whether @p topic is one of ROS 2 itself that nobody wants in a mission.
bool isHousekeeping(const std::string& topic) {
    return topic == "/rosout" || topic == "/parameter_events" || topic.find("/_action/") != std::string::npos;
}

/// Whether @p topic of a station refers to its own log, whose sequence numbers mean nothing in ours.
bool isOfAnotherLog(const std::string& topic) {
    return topic == station_topic::Checkpoints || topic == station_topic::Sessions ||
           topic == station_topic::Undo;
}

}  // namespace

struct MissionRecorder::State {
    RecorderSettings settings;
    Notify onMessage;
    std::unique_ptr<LiveMission> mission;
    std::unique_ptr<Node> node;
    std::vector<std::unique_ptr<LinkClient>> links;  ///< of the robots in the settings; fixed after start
    std::unique_ptr<MissionFeed> feed;
    std::unique_ptr<ReceptionWatch> reception;
    std::mutex mutex;  ///< guards the next two
    bool discovered = false;
    std::set<std::string> notified;
    std::condition_variable_any changed;
    ScreenMessages screened;  ///< used by the thread only
    std::jthread discovery;   ///< last: joined first

    void notify(const std::string& text) {
        if (onMessage) onMessage(text);
    }
    /// Reports @p text unless something was reported about @p key. Never called while locked, since the
    /// listener may query the state.
    void notifyOnce(const std::string& key, const std::string& text) {
        {
            const std::lock_guard lock(mutex);
            if (!notified.insert(key).second) return;
        }
        notify(text);
    }
    Result<void> watchLinks();
    void subscribeListed();
    void subscribeReceived();
    void watch(const std::stop_token& stop);
    void watchReception();
    [[nodiscard]] std::vector<std::string> notReceived() const;
};

Result<void> MissionRecorder::State::watchLinks() {
    LinkClientSettings passive;
    passive.pingEvery = std::chrono::milliseconds(0);
    for (const RobotDescription& robot : settings.mission.robots) {
        LinkListener listener;
        listener.onState = [this](const LinkStatus& link) { notify(linkLine(link)); };
        listener.onClockOffset = [this](const ClockOffsetSample& offset) {
            (void)mission->record(offset, station_topic::ClockOffsets);  // a plain sample can be encoded
        };
        auto client = LinkClient::create(*node, robot, passive, std::move(listener));
        if (!client) return client.error();
        links.push_back(std::move(client).value());
    }
    return {};
}

void MissionRecorder::State::subscribeListed() {
    for (const RobotDescription& robot : settings.mission.robots) {
        for (const std::string& problem : feed->listenTo(robot)) notify(problem);
    }
    for (const std::string& problem : feed->listenToStations()) notify(problem);
}

void MissionRecorder::State::subscribeReceived() {
    for (const RemoteEndpoint& endpoint : node->endpoints()) {
        if (endpoint.kind != RemoteEndpoint::Kind::Writer || !endpoint.ros ||
            isHousekeeping(endpoint.topic) || isOfAnotherLog(endpoint.topic))
            continue;
        const auto received = feed->listen(endpoint.topic, endpoint.type, endpoint.qos);
        if (!received) notifyOnce(endpoint.topic, received.error().text);
    }
}

void MissionRecorder::State::watch(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        {
            std::unique_lock lock(mutex);
            if (!changed.wait(lock, stop, [this] { return discovered; })) return;
            discovered = false;
        }
        if (settings.mission.robots.empty()) subscribeReceived();
        for (const Mismatch& mismatch : node->mismatches()) {
            const std::string text = toString(mismatch.complaint);
            notifyOnce(text, text);
        }
        for (const ScreenDrop& drop : screened.due(node->dropped())) notify(toString(drop));
    }
}

void MissionRecorder::State::watchReception() {
    ReceptionWatchSetup setup;
    setup.robots = settings.mission.robots;
    setup.link = [this](const std::string& robot) {
        for (const auto& link : links) {
            if (const LinkStatus status = link->status(); status.robot == robot) return status.state;
        }
        return LinkState::NeverSeen;
    };
    setup.mayRejoin = [] { return true; };  // it listens, and commands nobody
    setup.notify = [this](const std::string& text) { notify(text); };
    reception = std::make_unique<ReceptionWatch>(*node, std::move(setup));
}

/// Returns topics announced as steady streams for longer than it takes to receive them, without a sample.
/// Counts since the domain was joined, and also before a rejoin for that reason.
std::vector<std::string> MissionRecorder::State::notReceived() const {
    std::set<std::string> notReceived, received;
    for (const OfferedWriter& one : node->reception().writers) {
        if (one.received) received.insert(one.topic);
        if (!one.received && one.steady && one.seconds >= ReceivedWithin) notReceived.insert(one.topic);
    }
    for (const RobotDescription& robot : settings.mission.robots) {
        const auto fault = reception->fault(robot.name);
        if (!fault || fault->kind == ReceptionFault::Kind::Mute) continue;
        for (const std::string& topic : fault->names) {
            if (!received.contains(topic)) notReceived.insert(topic);
        }
    }
    return {notReceived.begin(), notReceived.end()};
}

Result<std::unique_ptr<MissionRecorder>> MissionRecorder::start(const RecorderSettings& settings,
                                                                Notify notify) {
    const auto network = nodeSettings(settings.domain, "leitstandctl record");
    if (!network) return network.error();
    auto node = Node::create(*network);
    if (!node) return node.error();
    auto mission = LiveMission::open(settings.mission, {.onAlarm = notify});
    if (!mission) return mission.error();
    auto state = std::make_unique<State>();
    state->settings = settings;
    state->onMessage = std::move(notify);
    state->mission = std::move(mission).value();
    state->node = std::move(node).value();
    for (const std::string& warning : state->node->warnings()) state->notify(warning);
    if (const auto watched = state->watchLinks(); !watched) return watched.error();
    state->feed = std::make_unique<MissionFeed>(*state->node, *state->mission,
                                                [raw = state.get()](const ReceivedSample& sample) {
                                                    for (const auto& link : raw->links)
                                                        link->onSample(sample);
                                                });
    if (!settings.mission.robots.empty()) state->subscribeListed();
    state->discovery = std::jthread([raw = state.get()](const std::stop_token& stop) { raw->watch(stop); });
    state->node->onDiscovery([raw = state.get()] {
        {
            const std::lock_guard lock(raw->mutex);
            raw->discovered = true;
        }
        raw->changed.notify_all();
    });
    state->watchReception();
    return std::unique_ptr<MissionRecorder>(new MissionRecorder(std::move(state)));
}

MissionRecorder::MissionRecorder(std::unique_ptr<State> state) : m_state(std::move(state)) {}

MissionRecorder::~MissionRecorder() {
    (void)stop();
    m_state->reception.reset();
    m_state->discovery.request_stop();
    if (m_state->discovery.joinable()) m_state->discovery.join();
    m_state->feed->end();
    m_state->links.clear();
    m_state->node.reset();
}

RecorderStatus MissionRecorder::status() const {
    RecorderStatus status{.log = m_state->mission->status(),
                          .topics = {},
                          .links = {},
                          .mismatches = {},
                          .notReceived = {},
                          .screened = {}};
    if (m_state->node) {
        for (const Mismatch& mismatch : m_state->node->mismatches())
            status.mismatches.push_back(toString(mismatch.complaint));
        status.screened = m_state->node->dropped();
    }
    for (const auto& link : m_state->links) status.links.push_back(link->status());
    if (m_state->node) status.notReceived = m_state->notReceived();
    status.topics = m_state->feed->topics();
    return status;
}

Result<void> MissionRecorder::stop() {
    // The log is closed first: a library's threads must not keep it open.
    return m_state->mission->close();
}

}  // namespace leitstand
