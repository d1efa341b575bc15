#include "core/mission/loops/open_loops.h"

#include <algorithm>
#include <variant>

#include "core/mission/state/decision.h"
#include "core/mission/state/mission_state.h"
#include "core/mission/state/scan_state.h"

namespace leitstand {
namespace {

constexpr double Together = 0.05;  ///< two places this near to where a link wants them are together [m] ...
constexpr double TogetherAngle = degrees(1.0);  ///< ... when also turned by at most this [rad]

/// Whether @p link, as the mission has it now, waits for an answer. Links of the operator are answers.
bool waits(const MissionState& state, const Link& link) {
    const auto now = state.loops->find(link.id);
    const auto asks = [](LinkKind kind) { return kind == LinkKind::Loop || kind == LinkKind::Session; };
    return now != state.loops->end() && !now->second.link.active && asks(now->second.link.kind) &&
           state.keyScans->contains(link.from) && state.keyScans->contains(link.to);
}

/// Whether the scans of @p link came to where it wants them after the event @p asked, which reported the
/// link.
bool holdsSince(const MissionState& state, const Link& link, std::uint64_t asked) {
    const KeyScanState &from = state.keyScans->at(link.from), &to = state.keyScans->at(link.to);
    if (from.poseSequence < asked && to.poseSequence < asked) return false;
    const Pose at = to.pose.scanInMap, would = from.pose.scanInMap * link.pose;
    return distanceBetween(at, would) <= Together && angleBetween(at, would) <= TogetherAngle;
}

}  // namespace

std::optional<OpenLoop> openLoop(const MissionState& state) {
    for (auto decision = state.decisions->rbegin(); decision != state.decisions->rend(); ++decision) {
        const auto* sample = std::get_if<ScanLinksSample>(&decision->content);
        if (sample == nullptr || decision->undone) continue;
        OpenLoop loop;
        loop.event = decision->sequence;
        for (const Link& link : sample->links) {
            if (waits(state, link)) loop.links.push_back(state.loops->at(link.id).link);
        }
        const bool holds = std::all_of(loop.links.begin(), loop.links.end(), [&](const Link& link) {
            return holdsSince(state, link, decision->sequence);
        });
        if (holds) continue;  // also when no link waits
        const Link& newest = loop.links.back();
        loop.parts = newest.kind == LinkKind::Session;
        loop.at = state.keyScans->at(newest.to).pose.scanInMap.translation();
        loop.would = (state.keyScans->at(newest.from).pose.scanInMap * newest.pose).translation();
        return loop;
    }
    return std::nullopt;
}

ScanLinksSample answerTo(const OpenLoop& loop, bool same, const std::string& station, Time now) {
    ScanLinksSample answer{now, station, loop.links};
    for (Link& link : answer.links) {
        link.kind = LinkKind::Operator;
        link.station = station;
        link.active = same;
    }
    return answer;
}

}  // namespace leitstand
