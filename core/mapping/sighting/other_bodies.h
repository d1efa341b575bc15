#pragma once

#include <vector>

#include "core/base/time.h"
#include "core/mapping/live/robot_tracker.h"
#include "core/mapping/live/scan_cleaning.h"

namespace leitstand {

/// Adds to @p bodies where @p robot, with @p body, was in the map from @p start to @p end (its own clock):
/// several places if it moved. Adds nothing where its pose is unknown. The less certain its pose is, the
/// wider is its margin. Scans of other robots leave out what lies on these bodies.
void addBodies(std::vector<PlacedBody>& bodies, const RobotTracker& robot, const RobotBody& body, Time start,
               Time end);

}  // namespace leitstand
