#pragma once

#include <string>
#include <vector>

#include "app/services/domain/robot_guess.h"
#include "transport/dds/endpoint.h"
#include "transport/dds/ros_nodes.h"

namespace leitstand {

/// Returns why DDS keeps the samples of @p endpoint from us, in words; empty when it does not.
[[nodiscard]] std::string obstacleOf(const RemoteEndpoint& endpoint);

/// Adds @p endpoint to what is known of its topic; @p isNew: nothing is known yet. True when @p topic was set
/// from it.
bool see(SeenTopic& topic, bool isNew, const RemoteEndpoint& endpoint, const RosNodes& nodes);

/// Returns the topics of @p endpoints, each once: as offered where somebody writes it, else as requested.
[[nodiscard]] std::vector<SeenTopic> seenTopics(const std::vector<RemoteEndpoint>& endpoints,
                                                const RosNodes& nodes);

}  // namespace leitstand
