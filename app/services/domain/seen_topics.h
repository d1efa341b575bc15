#pragma once

#include <string>
#include <vector>

#include "app/services/domain/robot_guess.h"
#include "transport/dds/endpoint.h"

namespace leitstand {

/// Why DDS keeps the samples of @p endpoint from us, in words; empty when it does not.
[[nodiscard]] std::string obstacleOf(const RemoteEndpoint& endpoint);

/// Takes @p endpoint into what is known of its topic; @p isNew: nothing is. True when it is told anew by it.
bool see(SeenTopic& topic, bool isNew, const RemoteEndpoint& endpoint);

/// The topics of @p endpoints, each once: as it is offered where somebody writes it, else as it is asked for.
[[nodiscard]] std::vector<SeenTopic> seenTopics(const std::vector<RemoteEndpoint>& endpoints);

}  // namespace leitstand
