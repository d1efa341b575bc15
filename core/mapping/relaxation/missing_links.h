#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/event/scan_links.h"
#include "core/mapping/live/map/live_map.h"

namespace leitstand {

/// Returns links for the scans of @p map that no active link of @p links leads to, although no part begins
/// with them. They are of missions from before there were links. Each is linked with the scan that it was
/// registered against (LiveKeyScan::matched), and loosely with the same robot's scan before, by their present
/// poses. The matches of relax() have more weight. Ids begin with @p first.
[[nodiscard]] std::vector<Link> missingLinks(const LiveMap& map, std::span<const Link> links,
                                             std::uint64_t first);

}  // namespace leitstand
