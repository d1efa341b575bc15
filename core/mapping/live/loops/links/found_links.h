#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/event/scan_links.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/scan_work.h"

namespace leitstand {

/// Returns the link between @p from and @p to by their present poses in the map.
[[nodiscard]] Link linkBetween(const LiveKeyScan& from, const LiveKeyScan& to, LinkKind kind);

/// Returns the information (inverse covariance) that a match gives about a scan's pose @p scanInMap, in the
/// scan's frame. Along directions that surfaces hold, it follows from LoopSettings::matchDeviation. It is
/// less along directions that surfaces hold weakly, and zero along open directions.
[[nodiscard]] Information informationOf(const IcpResult& icp, const Pose& scanInMap,
                                        const LoopSettings& loops, const MatchSettings& match);

/// How a scan entered the map.
struct Entry {
    const LiveKeyScan& scan;
    const LiveKeyScan* predecessor = nullptr;  ///< the robot's previous key scan; null: none
    std::span<const LiveKeyScan> against;      ///< scans that the scan was matched with, nearest first
    const Match& match;
};

/// Returns the odometry link from the scan's predecessor. If the scan fits, also returns links from the scans
/// that it was matched with. The odometry link then only holds directions that the match leaves open.
/// Otherwise a corridor would be as long as the wheels measure it.
[[nodiscard]] std::vector<Link> linksOf(const Entry& entry, const LoopSettings& loops,
                                        const MatchSettings& match);

}  // namespace leitstand
