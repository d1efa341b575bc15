#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct RobotDescription;

/// Footprints of robots by name: corners counter-clockwise, in base_link [m].
using Footprints = std::map<std::string, std::vector<Eigen::Vector2d>>;
[[nodiscard]] Footprints footprintsOf(std::span<const RobotDescription> robots);

/// Distance from the middle of a lying person to what touches them, at most [m]. It is half the length of the
/// arenas' dolls, whichever way they lie.
inline constexpr double HalfLying = 0.5;

/// Whether a robot at @p baseInMap touches a victim whose middle is at @p victimInMap [m] with @p bumper. A
/// bumper named after a side ("front", "rear_left") reaches as far as its part of the edge of @p footprint;
/// others reach all around. Without a footprint the robot is taken as 0.2 m wide to each side.
[[nodiscard]] bool touches(const Pose& baseInMap, const std::vector<Eigen::Vector2d>& footprint,
                           const std::string& bumper, const Eigen::Vector3d& victimInMap);

}  // namespace leitstand
