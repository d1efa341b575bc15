#pragma once

#include <optional>

#include "app/services/domain/seen_topic.h"
#include "core/robot/services/service_description.h"

namespace leitstand {

/// Returns the service whose requests are read on @p topic. Its name and type tell its part in a robot's
/// stop: an e-stop, or what cancels an action's goals. A topic of goals that the station sends stands for the
/// whole action. Empty: it is no service that the station calls.
[[nodiscard]] std::optional<ServiceDescription> guessService(const SeenTopic& topic);

}  // namespace leitstand
