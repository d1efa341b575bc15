#pragma once

#include <optional>
#include <string_view>

#include "core/robot/link/link_status.h"

namespace leitstand {

/// Reads a reason from its toString() text in an alarm of the log; without the topic, figures as rounded
/// there. Empty when @p reported is no such text.
[[nodiscard]] std::optional<LinkReason> linkReasonFrom(std::string_view reported);

}  // namespace leitstand
