#pragma once

#include "core/io/yaml/yaml_fields.h"
#include "core/robot/robot_description.h"

namespace leitstand::detail {

/// Reads the groups of joints that the operator moves ("joint_groups") into @p robot. Errors are added to
/// @p errors.
void readJointGroups(const YamlFields& fields, RobotDescription& robot, YamlErrors& errors);
/// Reports the groups that no stream commands; after the streams were read.
void checkJointCommands(const YamlFields& fields, const RobotDescription& robot);

}  // namespace leitstand::detail
