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

/// Footprints of robots by name: corners in counter-clockwise order, in base_link [m].
using Footprints = std::map<std::string, std::vector<Eigen::Vector2d>>;
[[nodiscard]] Footprints footprintsOf(std::span<const RobotDescription> robots);

/// Largest distance from the middle of a lying person at which something still touches the person [m]. It is
/// half the length of the dolls in the arenas, which may lie in any direction.
inline constexpr double HalfLying = 0.5;

/// Whether a robot at @p baseInMap touches, with @p bumper, a victim whose middle is at @p victimInMap [m]. A
/// bumper named after a side ("front", "rear_left") covers that part of the edge of @p footprint. Other
/// bumpers cover the whole edge. A robot without a footprint is treated as a disc with a radius of 0.2 m.
[[nodiscard]] bool touches(const Pose& baseInMap, const std::vector<Eigen::Vector2d>& footprint,
                           const std::string& bumper, const Eigen::Vector3d& victimInMap);

}  // namespace leitstand
