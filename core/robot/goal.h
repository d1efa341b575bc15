#pragma once

#include <cstdint>

#include "core/base/pose.h"

namespace leitstand {

/// Returns a goal on the map in the odometry frame of a robot. The robot is at @p baseInMap and, by its
/// odometry at the same moment, at @p baseInOdom. The result is level: robots drive on the ground, and
/// odometry may know no tilt.
[[nodiscard]] Pose goalInOdom(const Pose& baseInMap, const Pose& baseInOdom, const Pose& goalInMap);

/// What becomes of a goal on the map when the map moves.
enum class GoalMove : std::uint8_t {
    Stays,
    Moves,      ///< with the map: the robot gets it again
    Withdrawn,  ///< it would send the robot to an unintended place: the operator is asked
};
/// Returns what becomes of a goal when the map moves by @p correction there, put before poses. The goal is
/// @p underWay when the robot drives to it by itself, nothing stops it, and its mode is that in which it was
/// sent.
[[nodiscard]] GoalMove goalMove(const Pose& goalInMap, const Pose& correction, bool underWay);

}  // namespace leitstand
