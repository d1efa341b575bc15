#pragma once

#include <string>

#include <QString>

#include "core/mapping/live/robot_in_map.h"

namespace leitstand {

/// Returns @p how (RobotInMap::how) in the window's language: the reason why a robot's place is certain or
/// not.
[[nodiscard]] QString howText(const std::string& how);

/// Returns how certain the place of a robot is, and why: "place certain to 83 %: its scan fits the map",
/// "place uncertain, 12 %: little overlap". Empty: its place is unknown.
[[nodiscard]] QString placeText(const RobotInMap& place);

}  // namespace leitstand
