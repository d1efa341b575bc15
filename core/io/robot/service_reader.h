#pragma once

#include "core/io/yaml/yaml_fields.h"
#include "core/robot/robot_description.h"

namespace leitstand::detail {

/// Reads the list `services` of a robot's file into @p robot; there may be none.
void readServices(const YamlFields& fields, RobotDescription& robot, YamlErrors& errors);

}  // namespace leitstand::detail
