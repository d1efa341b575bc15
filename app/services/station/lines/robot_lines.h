#pragma once

#include <map>
#include <memory>
#include <string>

#include "app/services/station/lines/robot_line.h"
#include "app/services/station/safety/station_brakes.h"
#include "transport/link/grant_keeper.h"
#include "transport/link/stop_sender.h"

namespace leitstand {

/// A station's connections to its robots, by name.
using RobotLines = std::map<std::string, std::unique_ptr<RobotLine>>;

/// Gives the sticks only to @p robot, after all other robots were made to stand; empty: to no robot.
void giveSticks(const RobotLines& lines, const std::string& robot);

/// Returns the functions with which brake tests drive and query robots, except focus, refresh and done. All
/// arguments must outlive them.
[[nodiscard]] StationBrakes::Hands brakeHands(const RobotLines& lines, const GrantKeeper& grants,
                                              const StopSender& stops);

}  // namespace leitstand
