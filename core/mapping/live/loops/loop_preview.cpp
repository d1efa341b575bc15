#include "core/mapping/live/loops/loop_preview.h"

#include <algorithm>

namespace leitstand {

LoopPreview previewOf(const LiveMap& map, const MapSolution& solution, std::span<const Link> links,
                      const LoopSettings& settings) {
    LoopPreview preview;
    std::map<std::uint64_t, Pose> solved;
    for (const GraphNode& node : solution.nodes) solved.emplace(node.id, node.pose);
    for (const LiveKeyScan& scan : map.scans) {
        const auto after = solved.find(scan.id);
        if (after == solved.end() || !isNoticed(scan.pose.scanInMap, after->second, settings)) continue;
        preview.moved.insert(*after);
        preview.largest = std::max(preview.largest, distanceBetween(scan.pose.scanInMap, after->second));
    }
    preview.contradicted = std::any_of(links.begin(), links.end(), [&](const Link& link) {
        return std::find(solution.contradicted.begin(), solution.contradicted.end(), link.id) !=
               solution.contradicted.end();
    });
    return preview;
}

}  // namespace leitstand
