#include "core/mission/state/mission_state.h"

#include <algorithm>

namespace leitstand {

namespace {

/// Where something that hangs on a scan is now.
template <class Find>
Eigen::Vector3d placeOf(const MissionState& state, const Find& find) {
    const auto scan = state.keyScans->find(find.scan);
    if (find.scan == 0 || scan == state.keyScans->end()) return find.positionInMap;
    return scan->second.pose.scanInMap * find.positionInScan;
}

}  // namespace

Eigen::Vector3d positionInMap(const MissionState& state, const VictimSample& victim) {
    return placeOf(state, victim);
}

Eigen::Vector3d positionInMap(const MissionState& state, const CandidateSample& candidate) {
    return placeOf(state, candidate);
}

const Decision* decisionAt(const MissionState& state, std::uint64_t sequence) {
    const std::vector<Decision>& all = *state.decisions;
    const auto found = std::lower_bound(
        all.begin(), all.end(), sequence,
        [](const Decision& decision, std::uint64_t wanted) { return decision.sequence < wanted; });
    return found != all.end() && found->sequence == sequence ? &*found : nullptr;
}

}  // namespace leitstand
