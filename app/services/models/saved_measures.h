#pragma once

#include <string>

#include "core/base/result.h"
#include "core/robot/robot_description.h"
#include "core/robot/robot_measures.h"

namespace leitstand {

/// Writes @p measures to the file of @p robot, and leaves everything else in it as it is written. A file that
/// came with the program is copied to the user's folder. Returns the path of the file; errors name it.
[[nodiscard]] Result<std::string> saveMeasures(const RobotDescription& robot, const RobotMeasures& measures);

}  // namespace leitstand
