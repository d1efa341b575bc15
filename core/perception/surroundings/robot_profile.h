#pragma once

#include "core/perception/surroundings/scan_profile.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Clearance needed above a robot: it bounces, and its height is measured standing [m].
inline constexpr double HeadClearance = 0.10;

/// Returns what floor and obstacles are to @p robot: up to its height and HeadClearance, by the climb and the
/// step of its file. Values missing there are those of @p usual.
[[nodiscard]] ProfileSettings profileOf(const RobotDescription& robot, ProfileSettings usual = {});

}  // namespace leitstand
