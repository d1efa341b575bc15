#pragma once

#include <string>

#include "core/robot/robot_description.h"

namespace leitstand {

/// Returns the default stream of @p role for a robot called @p robot: topic, type and QoS of design section
/// 4. @p sensor: name of the camera for pictures ("left"). Transforms are on /tf, unless @p prefix is
/// TfPrefix::Topic.
/// 4. @p sensor names the camera of pictures ("left"). Transforms are on /tf, unless @p prefix distinguishes
/// robots by their topics.
[[nodiscard]] StreamDescription defaultStream(StreamRole role, const std::string& robot,
                                              const std::string& sensor, TfPrefix prefix = TfPrefix::Topic);

}  // namespace leitstand
