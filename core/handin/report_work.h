#pragma once

#include <cstddef>
#include <set>
#include <string>

namespace leitstand {

struct MissionState;

/// How people, robots and stations contributed to the results of a mission.
struct ReportWork {
    bool mappedLive = false;        ///< a station registered scans while robots drove
    std::size_t believed = 0;       ///< candidates that stations reported
    std::set<std::string> cues;     ///< kinds of the cues of these candidates (Cue::kind), without "sighting"
    std::size_t sighted = 0;        ///< those of these candidates that a robot also saw by itself
    std::size_t scanDecisions = 0;  ///< decisions of operators on scans and on the area of the map
    std::size_t filed = 0;          ///< finds that are not discarded
    std::size_t fromCandidates = 0;  ///< those of filed that come from candidates of a station
    std::size_t confirmed = 0;       ///< those of filed that operators confirmed
};

[[nodiscard]] ReportWork workOf(const MissionState& state);

}  // namespace leitstand
