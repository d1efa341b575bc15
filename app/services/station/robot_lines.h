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

/// Gives the sticks to @p robot alone; all others stand first. Empty: to none.
void giveSticks(const RobotLines& lines, const std::string& robot);

/// Returns what brake tests do with robots and ask of them, except focus, refresh and done. All arguments
/// outlive it.
[[nodiscard]] StationBrakes::Hands brakeHands(const RobotLines& lines, const GrantKeeper& grants,
                                              const StopSender& stops);

}  // namespace leitstand
