#pragma once

#include <string>

#include "core/base/words.h"
#include "core/robot/link/link_status.h"

namespace leitstand {

/// Returns the status of a link as text on a terminal: "kurt3d: degraded: odometry 1.4 s old".
[[nodiscard]] inline std::string linkLine(const LinkStatus& link) {
    const std::string reasons = toString(link.reasons);
    return link.robot + ": " + toString(link.state) + (reasons.empty() ? "" : ": " + reasons);
}

/// Returns the words that the window shows for a state.
[[nodiscard]] inline std::string linkStateWords(LinkState state) {
    switch (state) {
        case LinkState::NeverSeen:
            return translate("leitstand::LinkStatus", "not heard yet");
        case LinkState::Connected:
            return translate("leitstand::LinkStatus", "connected");
        case LinkState::Degraded:
            return translate("leitstand::LinkStatus", "degraded");
        case LinkState::Lost:
            return translate("leitstand::LinkStatus", "lost");
    }
    return {};
}

}  // namespace leitstand
