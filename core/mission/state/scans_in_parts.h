#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/mapping/graph/map_parts.h"
#include "core/mission/state/mission_state.h"
#include "core/mission/state/scan_state.h"

namespace leitstand {

/// Returns the key scans @p scans of a mission, by rising id, as input for findParts(). ScanInPart::part is
/// still 0 in all of them.
[[nodiscard]] inline std::vector<ScanInPart> scansInParts(
    const std::map<std::uint64_t, KeyScanState>& scans) {
    std::vector<ScanInPart> inParts;
    inParts.reserve(scans.size());
    for (const auto& [id, scan] : scans) {
        const std::uint64_t matched = scan.entry.matched;
        inParts.push_back({id, matched, beginsPart(matched, scan.pose.doubts), scan.entry.scanInMap, 0});
    }
    return inParts;
}

}  // namespace leitstand
