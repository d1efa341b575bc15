#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/event/scan_links.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/scan_work.h"

namespace leitstand {

/// @p from and @p to as they stand in the map.
[[nodiscard]] Link linkBetween(const LiveKeyScan& from, const LiveKeyScan& to, LinkKind kind);

/// What a match says of the pose of a scan at @p scanInMap, in the scan's frame: as much as
/// LoopSettings::matchDeviation along directions that surfaces hold, less along those that they hold less,
/// nothing along open ones.
[[nodiscard]] Information informationOf(const IcpResult& icp, const Pose& scanInMap,
                                        const LoopSettings& loops, const MatchSettings& match);

/// How a scan came into the map.
struct Entry {
    const LiveKeyScan& scan;
    const LiveKeyScan* predecessor = nullptr;  ///< the robot's key scan before; null: none
    std::span<const LiveKeyScan> against;      ///< what it was matched with, nearest first
    const Match& match;
};

/// The link to its predecessor, and to what it was matched with where that fitted. Odometry says only what
/// the match does not: else a corridor would be as long as the wheels have it.
[[nodiscard]] std::vector<Link> linksOf(const Entry& entry, const LoopSettings& loops,
                                        const MatchSettings& match);

}  // namespace leitstand
