#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/event/scan_links.h"
#include "core/mapping/live/map/live_map.h"

namespace leitstand {

/// Links for those scans of @p map that none of @p links, which are active, leads to, though they do not
/// begin a part: of missions of before there were links. Each hangs on the one that it was registered against
/// (LiveKeyScan::matched), and loosely on the robot's one before, as they stand. For relax(), whose matches
/// tell more. Ids from @p first on.
[[nodiscard]] std::vector<Link> missingLinks(const LiveMap& map, std::span<const Link> links,
                                             std::uint64_t first);

}  // namespace leitstand
