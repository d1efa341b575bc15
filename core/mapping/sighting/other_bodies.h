#pragma once

#include <vector>

#include "core/base/time.h"
#include "core/mapping/live/robot_tracker.h"
#include "core/mapping/live/scan_cleaning.h"

namespace leitstand {

/// Adds to @p bodies where @p robot, with @p body, was in the map from @p start to @p end (its own clock), as
/// it moved. Adds nothing where its pose is unknown. The less certain its pose is, the wider is its margin.
/// For scans of other robots, which must not keep it.
void addBodies(std::vector<PlacedBody>& bodies, const RobotTracker& robot, const RobotBody& body, Time start,
               Time end);

}  // namespace leitstand
