#pragma once

#include "core/io/robot/yaml_fields.h"
#include "core/robot/robot_description.h"

namespace leitstand::detail {

/// Reads the list `streams` of a robot's file into @p robot, whose name, frames and sensors are read already.
void readStreams(const YamlFields& fields, RobotDescription& robot, YamlErrors& errors);

}  // namespace leitstand::detail
