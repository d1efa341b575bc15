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

/// What robots stand on, by name: counter-clockwise, in base_link [m].
using Footprints = std::map<std::string, std::vector<Eigen::Vector2d>>;
[[nodiscard]] Footprints footprintsOf(std::span<const RobotDescription> robots);

/// How far the middle of somebody who lies may be from what touches them: half of the length of the arenas'
/// dolls, whichever way they lie [m].
inline constexpr double HalfLying = 0.5;

/// Whether a robot that stands at @p baseInMap touches a victim whose middle is at @p victimInMap [m] with @p
/// bumper: one that is called after a side ("front", "rear_left") reaches as far as its part of the edge of
/// @p footprint, others all about. Without a footprint the robot is taken for 0.2 m wide to each side.
[[nodiscard]] bool touches(const Pose& baseInMap, const std::vector<Eigen::Vector2d>& footprint,
                           const std::string& bumper, const Eigen::Vector3d& victimInMap);

}  // namespace leitstand
