#pragma once

#include <cstdint>

#include "core/base/pose.h"

namespace leitstand {

/// Converts a goal in the map to the odometry frame of a robot. The robot is at @p baseInMap and, by its
/// odometry at the same moment, at @p baseInOdom. The result is level: robots drive on the ground, and
/// odometry may know no tilt.
[[nodiscard]] Pose goalInOdom(const Pose& baseInMap, const Pose& baseInOdom, const Pose& goalInMap);

/// What becomes of a goal on the map when the map moves.
enum class GoalMove : std::uint8_t {
    Stays,
    Moves,      ///< it moves with the map, and is sent to the robot again
    Withdrawn,  ///< it would send the robot to an unintended place: the operator is asked
};
/// Returns what becomes of a goal when the map there is corrected: @p correction * pose replaces each pose.
/// Only a goal that is @p underWay and is shifted by less than 1 m may move. It is under way when the robot
/// drives to it by itself, nothing stops the robot, and its mode is still that in which the goal was sent.
[[nodiscard]] GoalMove goalMove(const Pose& goalInMap, const Pose& correction, bool underWay);

}  // namespace leitstand
