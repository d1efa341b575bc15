#pragma once

#include <cstdint>

#include "core/base/pose.h"

namespace leitstand {

/// Converts a goal in the map to the odometry frame of a robot. At the same moment the robot is at
/// @p baseInMap in the map and at @p baseInOdom in odometry. The result is level: robots drive on the ground,
/// and odometry may not measure tilt.
[[nodiscard]] Pose goalInOdom(const Pose& baseInMap, const Pose& baseInOdom, const Pose& goalInMap);

/// What happens to a goal on the map when the map moves.
enum class GoalMove : std::uint8_t {
    Stays,
    Moves,      ///< it moves with the map and is sent to the robot again
    Withdrawn,  ///< it would lead the robot to an unintended place: the operator is asked
};
/// Returns what happens to a goal when the map there is corrected: each pose becomes @p correction * pose.
/// Only a goal that is @p underWay and moves by less than 1 m may follow. A goal is under way if the robot
/// drives to it by itself, nothing stops the robot, and its mode has not changed since the goal was sent.
[[nodiscard]] GoalMove goalMove(const Pose& goalInMap, const Pose& correction, bool underWay);

}  // namespace leitstand
