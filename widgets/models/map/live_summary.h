#pragma once

#include <QString>

#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/robot_in_map.h"
#include "widgets/models/map_summary.h"

namespace leitstand {

/// What is to be told of a map that grows.
struct LiveMapFacts {
    const LiveMap& map;
    const RobotsInMap& robots;  ///< may be empty
    Time now{};                 ///< station's clock
    QString followed = {};      ///< letter of the robot that the view follows; may be empty
    QString kind = {};          ///< which map it is, where there are several; may be empty
    QString maker = {};         ///< another station, which makes it; empty: this one does
};

/// A map that grows in a line: "3D map · 47 key scans · 1.21 M points · follows K" and "certain · overlap
/// 83 % · last scan 1.4 s ago"; in brief without points and overlap. It is stale where scans were laid onto
/// it and none has been for MapStaleAfter.
[[nodiscard]] MapSummary liveSummaryOf(const LiveMapFacts& facts);

/// A few turns of a slow scanner [s].
inline constexpr double MapStaleAfter = 10.0;

}  // namespace leitstand
