#pragma once

#include "core/io/yaml/yaml_fields.h"
#include "core/robot/robot_description.h"

namespace leitstand::detail {

/// Reads the list `streams` of a robot's file into @p robot. Name, frames and sensors of @p robot must have
/// been read before.
void readStreams(const YamlFields& fields, RobotDescription& robot, YamlErrors& errors);

}  // namespace leitstand::detail
