#pragma once

#include <map>
#include <memory>
#include <string>

#include "app/services/station/robot_line.h"
#include "app/services/station/safety/station_brakes.h"
#include "transport/link/grant_keeper.h"
#include "transport/link/stop_sender.h"

namespace leitstand {

/// A station's lines to its robots, by name.
using RobotLines = std::map<std::string, std::unique_ptr<RobotLine>>;

/// Gives the sticks to @p robot alone, after all others were made to stand; empty: to no robot.
void giveSticks(const RobotLines& lines, const std::string& robot);

/// Returns the functions by which brake tests drive and query robots, without focus, refresh and done. All
/// arguments must outlive them.
[[nodiscard]] StationBrakes::Hands brakeHands(const RobotLines& lines, const GrantKeeper& grants,
                                              const StopSender& stops);

}  // namespace leitstand
