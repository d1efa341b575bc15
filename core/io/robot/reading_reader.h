#pragma once

#include <string_view>

#include "core/io/yaml/yaml_fields.h"
#include "core/robot/robot_description.h"

namespace leitstand::detail {

/// Whether @p text can be the ROS name of a message type, "sensor_msgs/msg/Temperature".
[[nodiscard]] bool isTypeName(std::string_view text);

/// Reads the list `readings` of @p stream, whose type must have been read before. Without a list, the stream
/// gets usualReadings().
void readReadings(const YamlFields& fields, StreamDescription& stream, YamlErrors& errors);

}  // namespace leitstand::detail
