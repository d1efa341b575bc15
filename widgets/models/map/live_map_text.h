#pragma once

#include <QString>

#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/robot_in_map.h"
#include "widgets/models/map_text.h"

namespace leitstand {

/// The facts that are shown about a growing map.
struct LiveMapFacts {
    const LiveMap& map;
    const RobotsInMap& robots;  ///< may be empty
    Time now{};                 ///< station's clock
    QString followed = {};      ///< letter of the robot that the camera follows; may be empty
    QString kind = {};          ///< which of several maps it is; may be empty
    QString maker = {};         ///< another station that makes the map; empty: this station does
};

/// Returns a summary of a growing map: "3D map · 47 key scans · 1.21 M points · follows K" and "certain ·
/// overlap 83 % · last scan 1.4 s ago". The short texts leave out points and overlap. The map is stale if the
/// last scan was matched with it more than MapStaleAfter ago.
[[nodiscard]] MapSummary liveSummaryOf(const LiveMapFacts& facts);

/// Time without a matched scan after which a map is stale: a few turns of a slow scanner [s].
inline constexpr double MapStaleAfter = 10.0;

}  // namespace leitstand
