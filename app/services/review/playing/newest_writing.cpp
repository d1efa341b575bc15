#include "app/services/review/playing/newest_writing.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <variant>

#include "core/event/station_samples.h"
#include "core/mission/finds/dismissal.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/mission_state.h"
#include "core/mission/state/session_state.h"

namespace leitstand {
namespace {

bool isReview(const SessionSample& session) {
    return session.title == ReviewTitle && session.station.starts_with(ReviewStation);
}

bool isWriting(const Decision& decision) {
    return !decision.undone && (std::holds_alternative<FindSample>(decision.content) ||
                                std::holds_alternative<NoteSample>(decision.content));
}

/// Returns the newest entry among the events of @p station after @p from and before @p to; all events there
/// are of that station.
ReviewWriting newestWithin(const MissionState& mission, const std::string& station, std::uint64_t from,
                           std::uint64_t to) {
    ReviewWriting newest;
    const auto& all = *mission.decisions;
    const auto end = std::lower_bound(
        all.begin(), all.end(), to,
        [](const Decision& decision, std::uint64_t sequence) { return decision.sequence < sequence; });
    for (auto one = std::make_reverse_iterator(end); one != all.rend() && one->sequence > from; ++one) {
        if (!isWriting(*one)) continue;
        newest.decision = &*one;
        from = one->sequence;
        break;
    }
    newest.dismissal = newestDismissal(mission, station, from);
    if (newest.dismissal != nullptr) newest.decision = nullptr;
    return newest;
}

}  // namespace

ReviewWriting newestWriting(const MissionState& mission) {
    const auto& all = *mission.sessions;
    // One session writes at a time: one that was cut off ended before the next began.
    std::uint64_t next = std::numeric_limits<std::uint64_t>::max();
    for (auto one = all.rbegin(); one != all.rend(); ++one) {
        const std::uint64_t end = one->ended == 0 ? next : std::min(one->ended, next);
        next = one->started;
        if (!isReview(one->session)) continue;
        if (const auto newest = newestWithin(mission, one->session.station, one->started, end)) return newest;
    }
    return {};
}

}  // namespace leitstand
