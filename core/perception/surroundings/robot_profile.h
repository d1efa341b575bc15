#pragma once

#include "core/perception/surroundings/scan_profile.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Free space needed above a robot [m]: it bounces while it drives, and its height was measured at rest.
inline constexpr double HeadClearance = 0.10;

/// Returns what counts as floor and obstacle for @p robot: its height plus HeadClearance, and the climb and
/// step from its file. Values that the file lacks are taken from @p usual.
[[nodiscard]] ProfileSettings profileOf(const RobotDescription& robot, ProfileSettings usual = {});

}  // namespace leitstand
