#include "core/mission/loops/moved_finds.h"

#include "core/event/find_sample.h"
#include "core/mission/state/find_state.h"

namespace leitstand {

std::vector<FindKey> findsMovedBy(const MissionState& state, const std::map<std::uint64_t, Pose>& scansInMap,
                                  double least) {
    std::vector<FindKey> moved;
    for (const auto& [key, find] : *state.finds) {
        const FindSample& victim = find.victim;
        const auto scan = scansInMap.find(victim.scan);
        if (scan == scansInMap.end() || victim.status == FindSample::Status::Discarded) continue;
        const Eigen::Vector3d after = scan->second * victim.positionInScan;
        if ((after - positionInMap(state, victim)).norm() > least) moved.push_back(key);
    }
    return moved;
}

}  // namespace leitstand
