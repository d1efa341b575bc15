#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/event/scan_links.h"
#include "core/mapping/live/map/live_map.h"

namespace leitstand {

/// Returns links for the scans of @p map that none of @p links, which are active, leads to, although they do
/// not begin a part. They are of missions from before there were links. Each scan is linked with the one it
/// was registered against (LiveKeyScan::matched), and loosely with the robot's scan before, as they stand.
/// The matches of relax() hold more. Ids begin with @p first.
[[nodiscard]] std::vector<Link> missingLinks(const LiveMap& map, std::span<const Link> links,
                                             std::uint64_t first);

}  // namespace leitstand
