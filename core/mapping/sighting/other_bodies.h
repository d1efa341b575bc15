#pragma once

#include <vector>

#include "core/base/time.h"
#include "core/mapping/live/robot_tracker.h"
#include "core/mapping/live/scan_cleaning.h"

namespace leitstand {

/// Adds to @p bodies where @p robot, whose shape is @p body, was in the map from @p start to @p end (its own
/// clock). If it moved, these are several places. Adds nothing where its pose is unknown. The less certain
/// its pose is, the wider the margin. Scans of other robots omit points on these bodies.
void addBodies(std::vector<PlacedBody>& bodies, const RobotTracker& robot, const RobotBody& body, Time start,
               Time end);

}  // namespace leitstand
