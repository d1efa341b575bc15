#include "app/services/domain/seen_topics.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace leitstand {

std::string obstacleOf(const RemoteEndpoint& endpoint) {
    if (endpoint.keyed) return "its samples are distinguished by keys, which ROS 2 never does";
    if (endpoint.exclusiveOwnership) return "exclusive ownership, which no reader of ROS 2 matches";
    if (!endpoint.partitions.empty()) {
        return fmt::format("it lives in partition \"{}\", outside the default one",
                           endpoint.partitions.front());
    }
    return {};
}

bool see(SeenTopic& topic, bool isNew, const RemoteEndpoint& endpoint, const RosNodes& nodes) {
    const bool writes = endpoint.kind == RemoteEndpoint::Kind::Writer;
    const bool again = isNew || (writes && !topic.written);
    if (again) {
        topic = {.name = endpoint.topic,
                 .type = endpoint.type,
                 .qos = endpoint.qos,
                 .written = writes,
                 .read = topic.read,
                 .obstacle = obstacleOf(endpoint),
                 .typeHash = endpoint.typeHash};
    }
    topic.read |= !writes;
    std::string node = writes == topic.written ? nodes.of(endpoint.guid) : std::string();
    if (!node.empty() && std::find(topic.nodes.begin(), topic.nodes.end(), node) == topic.nodes.end())
        topic.nodes.push_back(std::move(node));
    return again;
}

std::vector<SeenTopic> seenTopics(const std::vector<RemoteEndpoint>& endpoints, const RosNodes& nodes) {
    std::map<std::string, SeenTopic> topics;
    for (const RemoteEndpoint& endpoint : endpoints) {
        if (endpoint.topic == RosDiscoveryTopic) continue;  // ROS 2's own, and our watch
        const auto [place, isNew] = topics.try_emplace(endpoint.topic);
        see(place->second, isNew, endpoint, nodes);
    }
    std::vector<SeenTopic> all;
    all.reserve(topics.size());
    for (auto& [name, topic] : topics) all.push_back(std::move(topic));
    return all;
}

}  // namespace leitstand
