#pragma once

#include <optional>
#include <string>

#include "core/base/pose.h"

namespace leitstand {

struct RobotInMap;
struct RobotState;

/// Returns where @p frame of a robot lies in our map: its base, that of its odometry, or one above, in which
/// its own localisation places it ("map"). Our map tells where the odometry's frame lies, the robot's tf what
/// is above it. Empty: the robot has no place in the map, or no tf leads from the odometry's frame to @p
/// frame.
[[nodiscard]] std::optional<Pose> frameInMap(const std::string& frame, const RobotState& robot,
                                             const RobotInMap& place);

}  // namespace leitstand
