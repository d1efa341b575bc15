#include "app/services/domain/domain_probe.h"

#include <atomic>
#include <chrono>
#include <map>
#include <memory>
#include <set>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "app/services/domain/model_watch.h"
#include "app/services/domain/seen_topics.h"
#include "app/services/domain/topic_lane.h"
#include "core/base/time.h"
#include "transport/dds/node.h"
#include "transport/dds/ros_nodes.h"
#include "transport/domain/join_settings.h"

namespace leitstand {
namespace {

using Clock = std::chrono::steady_clock;

/// A topic listened to.
struct Probe {
    ProbedTopic probed;
    std::set<std::string> hosts;
    std::unique_ptr<Subscription> subscription;
    Clock::time_point since;
};

class Listening {
public:
    explicit Listening(Node& node) : m_node(node), m_watch(node) {}
    /// Looks up who is there, and subscribes to new topics.
    void look();
    [[nodiscard]] std::vector<ProbedTopic> topics();

private:
    void listen(Probe& probe);

    Node& m_node;
    const RosNodeWatch m_watch;
    std::map<std::string, Probe> m_probes;  ///< by topic
};

void Listening::listen(Probe& probe) {
    const SeenTopic& topic = probe.probed.topic;
    Qos qos = topic.qos;
    qos.depth = 100;
    qos.lifespan = qos.deadline = 0.0;
    auto subscription =
        m_node.subscribe({.topic = topic.name, .type = topic.type, .qos = qos, .lane = laneOf(topic.type)},
                         [](const ReceivedSample&) {});
    if (subscription) probe.subscription = std::move(subscription).value();
    probe.since = Clock::now();
}

void Listening::look() {
    for (auto& [name, probe] : m_probes) {
        probe.probed.writers = probe.probed.readers = 0;
        probe.probed.topic.read = false;
        probe.probed.topic.nodes.clear();
    }
    for (const RemoteEndpoint& endpoint : m_node.endpoints()) {
        if (endpoint.topic == RosDiscoveryTopic) continue;  // ROS 2's own, and our watch
        const bool writes = endpoint.kind == RemoteEndpoint::Kind::Writer;
        auto [place, isNew] = m_probes.try_emplace(endpoint.topic);
        Probe& probe = place->second;
        SeenTopic& topic = probe.probed.topic;
        if (see(topic, isNew, endpoint, m_watch.nodes())) probe.hosts.clear();
        ++(writes ? probe.probed.writers : probe.probed.readers);
        if (writes == topic.written) probe.hosts.insert(endpoint.host);
        if (writes && endpoint.ros && topic.obstacle.empty() && !probe.subscription) listen(probe);
    }
}

std::vector<ProbedTopic> Listening::topics() {
    std::vector<ProbedTopic> topics;
    for (auto& [name, probe] : m_probes) {
        ProbedTopic& probed = probe.probed;
        if (probe.subscription) {
            const SubscriptionCounts counts = probe.subscription->counts();
            const double seconds = toSeconds(Clock::now() - probe.since);
            probed.rate = static_cast<double>(counts.samples) / seconds;
            probed.bytesPerSecond = static_cast<double>(counts.bytes) / seconds;
            probed.lost = counts.lost;
        }
        probed.hosts.clear();
        for (const std::string& host : probe.hosts) probed.hosts += (probed.hosts.empty() ? "" : " ") + host;
        topics.push_back(probed);
    }
    return topics;
}

}  // namespace

struct DomainProbe::State {
    explicit State(std::unique_ptr<Node> joined) : node(std::move(joined)) {}
    std::unique_ptr<Node> node;
    ModelWatch models{*node};    ///< after the node, too
    Listening listening{*node};  ///< after the node: its subscriptions go first
};

Result<std::unique_ptr<DomainProbe>> DomainProbe::open(const DomainSettings& settings) {
    const auto network = nodeSettings(settings, "leitstandctl probe");
    if (!network) return network.error();
    auto node = Node::create(*network);
    if (!node) return node.error();
    return std::unique_ptr<DomainProbe>(new DomainProbe(std::make_unique<State>(std::move(node).value())));
}

DomainProbe::DomainProbe(std::unique_ptr<State> state) : m_state(std::move(state)) {}
DomainProbe::~DomainProbe() = default;

ProbeReport DomainProbe::listen(double seconds, const Progress& progress) {
    const Node& node = *m_state->node;
    ProbeReport report;
    report.warnings = node.warnings();
    const auto began = Clock::now();
    const auto elapsed = [&] { return toSeconds(Clock::now() - began); };
    while (elapsed() < seconds && !progress.cancelled()) {
        m_state->listening.look();
        std::vector<SeenTopic> seen = seenTopics(node.endpoints(), {});
        m_state->models.complete(seen);
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        progress.done(elapsed() / seconds);
    }
    report.seconds = elapsed();
    report.topics = m_state->listening.topics();
    for (const RemoteParticipant& participant : node.participants()) {
        if (participant.refused) {
            report.warnings.push_back(
                fmt::format("{} ({}) could not prove an identity that we accept (DDS-Security)",
                            participant.name, participant.host));
        }
    }
    for (const ScreenDrop& drop : node.dropped()) report.warnings.push_back(toString(drop));
    std::vector<SeenTopic> seen;
    for (const ProbedTopic& topic : report.topics) seen.push_back(topic.topic);
    m_state->models.complete(seen);
    report.robots = guessRobots(seen);
    return report;
}

}  // namespace leitstand
