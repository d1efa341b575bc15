#pragma once

#include <string>

#include "core/robot/link_status.h"

namespace leitstand {

/// A link for the operator: "kurt3d: degraded: odometry 1.4 s old".
[[nodiscard]] inline std::string linkLine(const LinkStatus& link) {
    const std::string reasons = toString(link.reasons);
    return link.robot + ": " + toString(link.state) + (reasons.empty() ? "" : ": " + reasons);
}

}  // namespace leitstand
