#include "core/mission/mission_state.h"

#include <algorithm>

namespace leitstand {

Eigen::Vector3d positionInMap(const MissionState& state, const VictimSample& victim) {
    const auto scan = state.keyScans->find(victim.scan);
    if (victim.scan == 0 || scan == state.keyScans->end()) return victim.positionInMap;
    return scan->second.pose.scanInMap * victim.positionInScan;
}

const Decision* decisionAt(const MissionState& state, std::uint64_t sequence) {
    const std::vector<Decision>& all = *state.decisions;
    const auto found = std::lower_bound(
        all.begin(), all.end(), sequence,
        [](const Decision& decision, std::uint64_t wanted) { return decision.sequence < wanted; });
    return found != all.end() && found->sequence == sequence ? &*found : nullptr;
}

}  // namespace leitstand
