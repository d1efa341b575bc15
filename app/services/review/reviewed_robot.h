#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "core/robot/link/link_status.h"
#include "core/robot/robot_description.h"
#include "core/station/alarms/alarm_book.h"
#include "core/station/robot_view.h"

namespace leitstand {

struct MissionState;

/// Converts a moment of a mission to the clock on which ages are measured.
[[nodiscard]] inline SteadyTime steadyOf(Time moment) {
    return SteadyTime(std::chrono::duration_cast<SteadyTime::duration>(moment.time_since_epoch()));
}

/// Returns how @p robot was at @p now, according to @p state: link, stop, and who had the grant to drive it.
/// A state has no surroundings, cameras and joints.
[[nodiscard]] RobotView reviewedRobot(const RobotDescription& robot, const MissionState& state, Time now);

/// Returns the alarms of @p state that were active at @p now, or had ended so recently that they were still
/// shown. They have the order of AlarmBook::alarms().
[[nodiscard]] std::vector<Alarm> reviewedAlarms(const MissionState& state, Time now);

}  // namespace leitstand
