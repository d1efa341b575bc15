#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/robot/link/link_status.h"

namespace leitstand {

/// Returns @p reason in the form for the log, without the topic: "stale stream=odometry seconds=1.4".
[[nodiscard]] std::string logged(const LinkReason& reason);
/// Reads a reason from the log: the text of logged(), or the English sentence in logs that are older than the
/// codes. Figures are rounded as in the text. Empty when @p reported is neither.
[[nodiscard]] std::optional<LinkReason> linkReasonFrom(std::string_view reported);

}  // namespace leitstand
