#include "core/mission/loops/open_loops.h"

#include <variant>

namespace leitstand {
namespace {

/// Whether @p link, as the mission has it now, waits for an answer: those of the operator are answers.
bool waits(const MissionState& state, const Link& link) {
    const auto now = state.loops->find(link.id);
    return now != state.loops->end() && !now->second.link.active && now->second.link.kind == LinkKind::Loop &&
           state.keyScans->contains(link.from) && state.keyScans->contains(link.to);
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
        if (loop.links.empty()) continue;
        const Link& newest = loop.links.back();
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
