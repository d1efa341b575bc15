#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/event/scan_links.h"
#include "core/mapping/live/map/live_map.h"

namespace leitstand {

/// Returns links for scans of @p map that have no active link in @p links and begin no part. They come from
/// old missions that had no links. Each is linked with the scan that it was registered against
/// (LiveKeyScan::matched), and loosely with the same robot's previous scan, by their present poses. Matches
/// of relax() have more weight than these links. Ids begin at @p first.
[[nodiscard]] std::vector<Link> missingLinks(const LiveMap& map, std::span<const Link> links,
                                             std::uint64_t first);

}  // namespace leitstand
