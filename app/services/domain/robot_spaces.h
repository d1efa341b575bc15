#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "app/services/domain/robot_guess.h"

namespace leitstand {

/// First part of a name with several: "/kurt3d/odom" -> "kurt3d"; empty for "/odom".
[[nodiscard]] std::string namespaceOf(std::string_view name);

/// Returns the namespace in which the nodes of @p topic were started, as far as its name and they tell:
/// "/kurt3d/odom" -> "kurt3d". A topic below the name of a node is private to it, and that node's namespace
/// counts: "/diffdrive_controller/cmd_vel" of a node "/diffdrive_controller" has none. Empty: it has none.
[[nodiscard]] std::string spaceOf(const SeenTopic& topic);

/// Returns the namespaces that are robots', by what only a robot's base has: commands to drive, odometry,
/// transforms of its own, what is specific to Leitstand. Drivers of sensors have namespaces too. Empty text:
/// the robot without a namespace.
[[nodiscard]] std::set<std::string> robotSpaces(const std::vector<SeenTopic>& topics);

}  // namespace leitstand
