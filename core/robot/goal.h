#pragma once

#include <cstdint>

#include "core/base/pose.h"

namespace leitstand {

/// Where a goal of the map lies in the odometry's frame of a robot that is at @p baseInMap and, by its
/// odometry at the same moment, at @p baseInOdom. Level: robots drive on the ground, and odometry may know no
/// tilt.
[[nodiscard]] Pose goalInOdom(const Pose& baseInMap, const Pose& baseInOdom, const Pose& goalInMap);

/// What becomes of a goal on the map when the map moves.
enum class GoalMove : std::uint8_t {
    Stays,
    Moves,      ///< with the map: the robot is told anew
    Withdrawn,  ///< it would send the robot somewhere that nobody meant: the operator is asked
};
/// @p correction: how the map moves at the goal, to put before poses there. @p underWay: the robot drives to
/// it by itself, nothing stops it, and it is in the mode in which it was sent.
[[nodiscard]] GoalMove goalMove(const Pose& goalInMap, const Pose& correction, bool underWay);

}  // namespace leitstand
