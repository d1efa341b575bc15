#pragma once

#include <cstddef>
#include <set>
#include <string>

#include "core/mission/state/mission_state.h"

namespace leitstand {

/// What of a mission's results people, robots and stations worked out.
struct ReportWork {
    bool mappedLive = false;         ///< a station registered scans while robots drove
    std::size_t believed = 0;        ///< candidates that stations told of
    std::set<std::string> cues;      ///< kinds of what they had them from, as Cue::kind
    std::size_t sighted = 0;         ///< of these, candidates that a robot had seen by itself, too
    std::size_t scanDecisions = 0;   ///< of operators, on scans and on what belongs into the map
    std::size_t filed = 0;           ///< finds that are not discarded
    std::size_t fromCandidates = 0;  ///< of these, that a station had believed in
    std::size_t confirmed = 0;       ///< of these, by operators
};

[[nodiscard]] ReportWork workOf(const MissionState& state);

}  // namespace leitstand
