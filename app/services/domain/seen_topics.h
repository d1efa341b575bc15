#pragma once

#include <string>
#include <vector>

#include "app/services/domain/seen_topic.h"
#include "transport/dds/endpoint.h"
#include "transport/dds/ros_nodes.h"

namespace leitstand {

/// Returns in words why DDS cannot deliver the samples of @p endpoint to this station; empty: it can.
[[nodiscard]] std::string obstacleOf(const RemoteEndpoint& endpoint);

/// Adds @p endpoint to what is known about its @p topic. @p isNew: nothing is known yet. Returns whether
/// @p topic was set from this endpoint alone.
bool see(SeenTopic& topic, bool isNew, const RemoteEndpoint& endpoint, const RosNodes& nodes);

/// Returns the topics of @p endpoints, each once: as its writers offer it, or if there are none, as its
/// readers request it.
[[nodiscard]] std::vector<SeenTopic> seenTopics(const std::vector<RemoteEndpoint>& endpoints,
                                                const RosNodes& nodes);

}  // namespace leitstand
