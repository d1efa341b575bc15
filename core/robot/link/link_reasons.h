#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/robot/link/link_status.h"

namespace leitstand {

/// Returns @p reason for the log, without the topic: "stale stream=odometry seconds=1.4".
[[nodiscard]] std::string logged(const LinkReason& reason);
/// Reads a reason from the log: what logged() wrote, or the English sentence of logs older than the codes;
/// figures are as rounded there. Empty when @p reported is neither.
[[nodiscard]] std::optional<LinkReason> linkReasonFrom(std::string_view reported);

}  // namespace leitstand
