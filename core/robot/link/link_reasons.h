#pragma once

#include <optional>
#include <string_view>

#include "core/robot/link/link_status.h"

namespace leitstand {

/// What toString() of a reason says, read again from alarms of the log; without the topic, figures as rounded
/// there. Empty: it is none of its sentences.
[[nodiscard]] std::optional<LinkReason> linkReasonFrom(std::string_view said);

}  // namespace leitstand
