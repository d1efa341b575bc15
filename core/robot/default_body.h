#pragma once

#include "core/robot/robot_description.h"

namespace leitstand {

/// Sets the frames, sizes and limits that @p robot lacks (empty, or not above 0). The defaults are those of a
/// robot file: base_link and odom, 0.5 x 0.4 m, 0.5 m high, tilt up to 25 degrees, 0.3 m/s, 30 degrees/s.
void fillBody(RobotDescription& robot);

}  // namespace leitstand
