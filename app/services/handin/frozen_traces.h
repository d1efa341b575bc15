#pragma once

#include "app/services/handin/report_content.h"
#include "core/event/event.h"

namespace leitstand {

class ReportSource;

/// Puts evidence that is no picture into @p pages: CO2, a scan (a cloud, ranges, or a key scan), the robot's
/// odometry. Other events are left alone.
void addTrace(FindPages& pages, const Event& event, const ReportFind& find, const ReportModel& model,
              ReportSource& source);

/// Brings the CO2 of @p pages into order, by robot and time; what was measured more than a minute apart is a
/// trace of its own.
void joinGas(FindPages& pages);

}  // namespace leitstand
