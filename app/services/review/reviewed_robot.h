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

/// Returns a moment of a mission on the clock that ages are measured on.
[[nodiscard]] inline SteadyTime steadyOf(Time moment) {
    return SteadyTime(std::chrono::duration_cast<SteadyTime::duration>(moment.time_since_epoch()));
}

/// Returns how @p robot was at @p now, by @p state: link, stop, and who had the grant to drive it. A state
/// does not hold surroundings, cameras and joints.
[[nodiscard]] RobotView reviewedRobot(const RobotDescription& robot, const MissionState& state, Time now);

/// Returns the alarms of @p state that stood at @p now, or had ended so shortly before that they were still
/// shown. Their order is that of AlarmBook::alarms().
[[nodiscard]] std::vector<Alarm> reviewedAlarms(const MissionState& state, Time now);

}  // namespace leitstand
