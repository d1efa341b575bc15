#pragma once

#include <QString>

#include "core/robot/wire_complaint.h"

namespace leitstand {

/// "/kurt3d/odom: robot offers best effort, we asked for reliable", in the user's language but for the terms
/// of DDS and ROS 2, which are those of robots' files.
[[nodiscard]] QString wireText(const WireComplaint& complaint);

}  // namespace leitstand
