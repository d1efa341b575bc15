#include "app/services/log/mission_feed.h"

#include <algorithm>

#include "app/services/domain/station_types.h"
#include "app/services/domain/topic_lane.h"
#include "core/event/stream_role.h"
#include "transport/dds/node.h"

namespace leitstand {
namespace {

/// Deep enough that a burst is not lost between the network and the queue.
Qos recording(Qos qos) {
    qos.depth = std::max(qos.depth, 100);
    qos.lifespan = 0.0;
    qos.deadline = 0.0;
    return qos;
}

}  // namespace

MissionFeed::MissionFeed(Node& node, LiveMission& mission, Tap tap)
    : m_node(node), m_mission(mission), m_tap(std::move(tap)) {}

MissionFeed::~MissionFeed() {
    end();
}

Result<void> MissionFeed::listen(const std::string& topic, const std::string& type, const Qos& qos,
                                 const Gate& gate) {
    {
        const std::lock_guard lock(m_mutex);
        if (m_topics.contains(topic)) return {};
    }
    m_mission.addTopic(topic, type, qos);
    auto subscription =
        m_node.subscribe({.topic = topic, .type = type, .qos = recording(qos), .lane = laneOf(type)},
                         [this, gate](ReceivedSample sample) {
                             if (m_tap) m_tap(sample);
                             if (gate) return gate(std::move(sample));
                             m_mission.receive(std::move(sample.event));
                         });
    if (!subscription) return subscription.error();
    const std::lock_guard lock(m_mutex);
    m_topics.emplace(topic, Listening{type, std::move(subscription).value()});
    return {};
}

std::vector<std::string> MissionFeed::listenTo(const RobotDescription& robot, Commands commands) {
    std::vector<std::string> problems;
    for (const StreamDescription& stream : robot.streams) {
        if (!stream.record || (commands == Commands::Left && isCommand(stream.role))) continue;
        if (const auto subscribed = listen(stream.topic, stream.type, stream.qos); !subscribed)
            problems.push_back(subscribed.error().text);
    }
    return problems;
}

std::vector<std::string> MissionFeed::listenToStations(const Gate& gate) {
    const Qos qos{.reliability = Qos::Reliability::Reliable, .durability = Qos::Durability::TransientLocal};
    std::vector<std::string> problems;
    for (const StationType& one : StationTypes) {
        if (const auto subscribed = listen(std::string(one.topic), std::string(one.type), qos, gate);
            !subscribed)
            problems.push_back(subscribed.error().text);
    }
    return problems;
}

std::vector<RecordedTopic> MissionFeed::topics() const {
    std::vector<RecordedTopic> topics;
    const std::lock_guard lock(m_mutex);
    for (const auto& [name, listening] : m_topics) {
        const SubscriptionCounts counts = listening.subscription->counts();
        topics.push_back({name, listening.type, counts.samples, counts.lost, counts.writers});
    }
    return topics;
}

void MissionFeed::end() {
    decltype(m_topics) ended;
    {
        const std::lock_guard lock(m_mutex);
        ended.swap(m_topics);
    }
    // Callbacks end here, without the lock.
}

}  // namespace leitstand
