#pragma once

#include <string>
#include <vector>

#include <QString>

#include "core/robot/robot_description.h"

namespace leitstand {

/// What the operator calls the one of @p robots of this name; another one's name as it is.
[[nodiscard]] inline QString titleOfRobot(const std::vector<RobotDescription>& robots,
                                          const std::string& name) {
    for (const RobotDescription& one : robots) {
        if (one.name == name && !one.title.empty()) return QString::fromStdString(one.title);
    }
    return QString::fromStdString(name);
}

}  // namespace leitstand
