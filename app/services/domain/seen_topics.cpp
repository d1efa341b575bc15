#include "app/services/domain/seen_topics.h"

#include <map>

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

bool see(SeenTopic& topic, bool isNew, const RemoteEndpoint& endpoint) {
    const bool writes = endpoint.kind == RemoteEndpoint::Kind::Writer;
    const bool again = isNew || (writes && !topic.written);
    if (again) {
        topic = {.name = endpoint.topic,
                 .type = endpoint.type,
                 .qos = endpoint.qos,
                 .written = writes,
                 .read = topic.read,
                 .obstacle = obstacleOf(endpoint)};
    }
    topic.read |= !writes;
    return again;
}

std::vector<SeenTopic> seenTopics(const std::vector<RemoteEndpoint>& endpoints) {
    std::map<std::string, SeenTopic> topics;
    for (const RemoteEndpoint& endpoint : endpoints) {
        const auto [place, isNew] = topics.try_emplace(endpoint.topic);
        see(place->second, isNew, endpoint);
    }
    std::vector<SeenTopic> all;
    for (auto& [name, topic] : topics) all.push_back(std::move(topic));
    return all;
}

}  // namespace leitstand
