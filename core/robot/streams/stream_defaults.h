#pragma once

#include <string>

#include "core/robot/robot_description.h"

namespace leitstand {

/// The stream of @p role that a robot called @p robot has when its file says nothing else: topic, type and
/// QoS of design section 4. @p sensor names the camera of pictures ("left"); unless robots are told by their
/// topics (@p prefix), transforms are on /tf.
[[nodiscard]] StreamDescription defaultStream(StreamRole role, const std::string& robot,
                                              const std::string& sensor, TfPrefix prefix = TfPrefix::Topic);

}  // namespace leitstand
