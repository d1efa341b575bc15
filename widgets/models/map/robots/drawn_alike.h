#pragma once

#include "core/base/pose.h"

namespace leitstand {

/// Whether what lies at @p a and at @p b is drawn alike: less than a centimetre and a tenth of a degree
/// apart.
[[nodiscard]] inline bool drawnAlike(const Pose& a, const Pose& b) {
    constexpr double Apart = 0.01, Turned = 0.0017;  // [m], [rad]
    return distanceBetween(a, b) < Apart && angleBetween(a, b) < Turned;
}

}  // namespace leitstand
