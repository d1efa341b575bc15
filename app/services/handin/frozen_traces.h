#pragma once

#include "app/services/handin/report_content.h"

namespace leitstand {

struct Event;
class ReportSource;

/// Adds evidence that is no picture to @p pages: CO2, a scan (a cloud, ranges, or a key scan), or the robot's
/// odometry. Ignores other events.
void addTrace(FindPages& pages, const Event& event, const ReportFind& find, const ReportModel& model,
              ReportSource& source);

/// Sorts the CO2 in @p pages by robot and time. Readings more than a minute apart begin another trace.
void joinGas(FindPages& pages);

}  // namespace leitstand
