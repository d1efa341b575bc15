#include "core/mapping/live/loops/loop_preview.h"

#include <algorithm>

namespace leitstand {

LoopPreview previewOf(const LiveMap& map, const MapSolution& solution, const LoopSettings& settings) {
    LoopPreview preview;
    std::map<std::uint64_t, Pose> solved;
    for (const GraphNode& node : solution.nodes) solved.emplace(node.id, node.pose);
    for (const LiveKeyScan& scan : map.scans) {
        const auto after = solved.find(scan.id);
        if (after == solved.end()) continue;
        const Pose& before = scan.pose.scanInMap;
        const double shift = distanceBetween(before, after->second);
        if (shift <= settings.previewed && angleBetween(before, after->second) <= settings.previewedAngle)
            continue;
        preview.moved.insert(*after);
        preview.largest = std::max(preview.largest, shift);
    }
    preview.parted = solution.contradicted.size();
    return preview;
}

}  // namespace leitstand
