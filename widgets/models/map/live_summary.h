#pragma once

#include <QString>

#include "core/mapping/live/live_map.h"
#include "widgets/models/map_summary.h"

namespace leitstand {

/// A map that grows in a line: "3D map · 47 key scans · 1.21 M points · follows K" and "last scan 1.4 s ago ·
/// overlap 83 % · certain". @p followed: letter of the robot that the view follows, may be empty. @p kind:
/// which map it is, where there are several; may be empty.
[[nodiscard]] MapSummary liveSummaryOf(const LiveMap& map, const QString& followed, Time now,
                                       const QString& kind = {});

}  // namespace leitstand
