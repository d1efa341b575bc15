#pragma once

#include "core/perception/surroundings/scan_profile.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Clearance needed above a robot: it bounces while it drives, and its height is measured at rest [m].
inline constexpr double HeadClearance = 0.10;

/// Returns what floor and obstacles are to @p robot: its height plus HeadClearance, and the climb and step of
/// its file. Values that the file lacks are those of @p usual.
[[nodiscard]] ProfileSettings profileOf(const RobotDescription& robot, ProfileSettings usual = {});

}  // namespace leitstand
