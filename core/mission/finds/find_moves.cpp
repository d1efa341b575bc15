#include "core/mission/finds/find_moves.h"

#include <algorithm>
#include <optional>
#include <variant>

#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/station_samples.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/decisions.h"
#include "core/mission/state/find_state.h"

namespace leitstand {
namespace {

using Cause = FindMove::Cause;

/// Returns why finds move by @p decision; empty: it moves no scans.
std::optional<Cause> causeOf(const Decision& decision) {
    if (std::holds_alternative<UndoSample>(decision.content)) return Cause::Undo;
    const auto* poses = std::get_if<ScanPosesSample>(&decision.content);
    if (poses == nullptr) return std::nullopt;
    switch (poses->cause) {
        case ScanPosesSample::Cause::Registration:
            return Cause::Registration;
        case ScanPosesSample::Cause::LoopClosure:
            return Cause::LoopClosure;
        case ScanPosesSample::Cause::Operator:
            break;
    }
    return Cause::Operator;
}

bool isPlacedAlike(const FindSample& a, const FindSample& b) {
    return a.scan == b.scan && a.positionInScan == b.positionInScan && a.positionInMap == b.positionInMap;
}

}  // namespace

std::vector<FindMove> FindMoves::follow(const MissionState& state) {
    const std::vector<Decision>& decisions = *state.decisions;
    const bool goesOn =
        m_taken <= decisions.size() && (m_taken == 0 || decisions[m_taken - 1].sequence == m_last);
    if (!goesOn) *this = FindMoves();
    const std::size_t before = m_all.size();
    for (; m_taken < decisions.size(); ++m_taken) {
        take(decisions[m_taken]);
        m_last = decisions[m_taken].sequence;
    }
    return {m_all.begin() + static_cast<std::ptrdiff_t>(before), m_all.end()};
}

void FindMoves::take(const Decision& decision) {
    const std::optional<Cause> cause = causeOf(decision);
    Decision then = decision;
    then.undone = false;  // what took it back comes later
    decide(m_replay, std::move(then));
    for (const auto& [key, entry] : *m_replay.finds) {
        const Eigen::Vector3d place = positionInMap(m_replay, entry.victim);
        const auto [known, fresh] = m_reported.try_emplace(key, Reported{entry, place});
        if (fresh) continue;
        Reported& earlier = known->second;
        if (!isPlacedAlike(earlier.entry.victim, entry.victim)) {
            earlier = {entry, place};  // put elsewhere by its own entry
            continue;
        }
        if (!cause || (place - earlier.inMap).norm() <= LeastMove) continue;
        m_all.push_back({key, *cause, decision.sequence, decision.received, earlier.inMap, place});
        earlier.inMap = place;
    }
    std::erase_if(m_reported, [this](const auto& one) { return !m_replay.finds->contains(one.first); });
}

const FindMove* FindMoves::newest(const FindKey& find) const {
    const auto found =
        std::find_if(m_all.rbegin(), m_all.rend(), [&](const FindMove& move) { return move.find == find; });
    return found == m_all.rend() ? nullptr : &*found;
}

}  // namespace leitstand
