#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// The robots of @p files: paths, or names of shipped ones. Errors name the file.
[[nodiscard]] Result<std::vector<RobotDescription>> chooseRobots(const std::vector<std::string>& files);

}  // namespace leitstand
