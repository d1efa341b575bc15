#pragma once

#include <string>

#include "core/robot/robot_description.h"

namespace leitstand {

/// Returns the default stream with @p role for a robot called @p robot: topic, type and QoS as in design
/// section 4. @p sensor names the camera of pictures ("left"). Transforms are on /tf, unless @p prefix is
/// TfPrefix::Topic.
[[nodiscard]] StreamDescription defaultStream(StreamRole role, const std::string& robot,
                                              const std::string& sensor, TfPrefix prefix = TfPrefix::Topic);

}  // namespace leitstand
