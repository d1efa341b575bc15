#include "core/mission/state/mission_state.h"

#include <algorithm>

#include "core/event/candidate_sample.h"
#include "core/event/find_sample.h"
#include "core/event/scan_bodies.h"
#include "core/event/scan_links.h"
#include "core/event/station_samples.h"
#include "core/mission/state/crop_state.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/scan_state.h"
#include "core/mission/state/session_state.h"

namespace leitstand {

MissionState::MissionState() = default;

namespace {

/// Returns where something that hangs on a scan is now, in the map [m].
template <class Find>
Eigen::Vector3d placeOf(const MissionState& state, const Find& find) {
    const auto scan = state.keyScans->find(find.scan);
    if (find.scan == 0 || scan == state.keyScans->end()) return find.positionInMap;
    return scan->second.pose.scanInMap * find.positionInScan;
}

}  // namespace

Eigen::Vector3d positionInMap(const MissionState& state, const FindSample& victim) {
    return placeOf(state, victim);
}

Eigen::Vector3d positionInMap(const MissionState& state, const CandidateSample& candidate) {
    return placeOf(state, candidate);
}

std::vector<Eigen::Vector2d> areaInMap(const MissionState& state) {
    std::vector<Eigen::Vector2d> area;
    if (!state.crop) return area;
    for (const AreaCorner& corner : state.crop->corners) {
        area.push_back(corner.drawn);
        const auto scan = state.keyScans->find(corner.scan);
        if (scan == state.keyScans->end()) continue;
        const Pose& now = scan->second.pose.scanInMap;
        if (now.matrix() == corner.scanInMap.matrix()) continue;
        const Eigen::Vector3d then(corner.drawn.x(), corner.drawn.y(), corner.scanInMap.translation().z());
        area.back() = (now * corner.scanInMap.inverse() * then).head<2>();
    }
    return area;
}

std::vector<Link> loopsOf(const MissionState& state) {
    std::map<std::uint64_t, Link> links;
    for (const Decision& decision : *state.decisions) {
        const auto* sample = std::get_if<ScanLinksSample>(&decision.content);
        if (sample == nullptr) continue;
        for (const Link& link : sample->links) {
            const auto stands = state.loops->find(link.id);
            Link& now = links[link.id];
            now = stands != state.loops->end() ? stands->second.link : link;
            now.active = now.active && stands != state.loops->end();
        }
    }
    std::vector<Link> all;
    for (auto& [id, link] : links) all.push_back(std::move(link));
    return all;
}

const Decision* decisionAt(const MissionState& state, std::uint64_t sequence) {
    const std::vector<Decision>& all = *state.decisions;
    const auto found = std::lower_bound(
        all.begin(), all.end(), sequence,
        [](const Decision& decision, std::uint64_t wanted) { return decision.sequence < wanted; });
    return found != all.end() && found->sequence == sequence ? &*found : nullptr;
}

}  // namespace leitstand
