#pragma once

#include <string>
#include <vector>

#include <QString>

#include "core/robot/robot_description.h"

namespace leitstand {

/// Returns the title of the robot @p name in @p robots. Returns @p name if the robot is unknown or has no
/// title.
[[nodiscard]] inline QString titleOfRobot(const std::vector<RobotDescription>& robots,
                                          const std::string& name) {
    for (const RobotDescription& one : robots) {
        if (one.name == name && !one.title.empty()) return QString::fromStdString(one.title);
    }
    return QString::fromStdString(name);
}

}  // namespace leitstand
