#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "app/services/domain/seen_topic.h"

namespace leitstand {

/// Returns the first part of a name with several parts: "/kurt3d/odom" -> "kurt3d"; empty for "/odom".
[[nodiscard]] std::string namespaceOf(std::string_view name);

/// Returns the namespace of @p topic from its name: "/kurt3d/odom" -> "kurt3d". If the name begins with the
/// name of one of its nodes, the topic is private to that node, and has the node's namespace. So
/// "/diffdrive_controller/cmd_vel" of the node "/diffdrive_controller" has none. Empty: no namespace.
[[nodiscard]] std::string spaceOf(const SeenTopic& topic);

/// Returns the namespaces that belong to robots. Sensor drivers have namespaces, too. A robot's namespace has
/// topics of a mobile base: drive commands, odometry, its own transforms, or Leitstand's own messages. An
/// empty text stands for the robot without a namespace.
[[nodiscard]] std::set<std::string> robotSpaces(const std::vector<SeenTopic>& topics);

}  // namespace leitstand
