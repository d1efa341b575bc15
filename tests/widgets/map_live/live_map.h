#pragma once

#include "core/mapping/map.h"
#include "widgets/models/map/robots/robot_mark.h"

namespace leitstand::test {

/// The generated room of roomMap() as a live map has it: scans of Kurt3D with ids from 1; the second one is
/// @p uncertain.
[[nodiscard]] MapPtr liveRoom(bool uncertain = false);

/// Kurt3D at @p baseInMap, selected, with a trail behind it.
[[nodiscard]] RobotMark kurt3d(const Pose& baseInMap);
/// The Crawler at @p baseInMap.
[[nodiscard]] RobotMark crawler(const Pose& baseInMap);
/// Level, on the room's floor [m, rad].
[[nodiscard]] Pose onFloor(double x, double y, double heading);

inline constexpr double RoomFloor = -1.0;  ///< of liveRoom(), map frame [m]

}  // namespace leitstand::test
