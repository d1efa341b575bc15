#pragma once

#include "app/services/handin/report_content.h"

namespace leitstand {

struct Event;
class ReportSource;

/// Adds evidence that is no picture to @p pages: CO2, a scan (a cloud, ranges, or a key scan), the robot's
/// odometry. Ignores other events.
void addTrace(FindPages& pages, const Event& event, const ReportFind& find, const ReportModel& model,
              ReportSource& source);

/// Sorts the CO2 of @p pages by robot and time; readings more than a minute apart start another trace.
void joinGas(FindPages& pages);

}  // namespace leitstand
