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

/// Returns the information (inverse covariance) of a match on the pose of a scan at @p scanInMap, in the
/// scan's frame. Along directions that surfaces hold, it is that of LoopSettings::matchDeviation. It is less
/// along directions that surfaces hold weakly, and zero along open ones.
[[nodiscard]] Information informationOf(const IcpResult& icp, const Pose& scanInMap,
                                        const LoopSettings& loops, const MatchSettings& match);

/// How a scan entered the map.
struct Entry {
    const LiveKeyScan& scan;
    const LiveKeyScan* predecessor = nullptr;  ///< the robot's key scan before; null: none
    std::span<const LiveKeyScan> against;      ///< scans that it was matched with, nearest first
    const Match& match;
};

/// Returns the link from the scan's predecessor, by odometry. If the scan fits, also returns links from the
/// scans that it was matched with. Then odometry holds only what the match leaves open. Otherwise a corridor
/// would be as long as the wheels measure it.
[[nodiscard]] std::vector<Link> linksOf(const Entry& entry, const LoopSettings& loops,
                                        const MatchSettings& match);

}  // namespace leitstand
