#pragma once

#include <cstddef>
#include <set>
#include <string>

namespace leitstand {

struct MissionState;

/// How people, robots and stations contributed to the results of a mission.
struct ReportWork {
    bool mappedLive = false;     ///< whether a station registered scans while robots drove
    std::size_t believed = 0;    ///< number of candidates that stations reported
    std::set<std::string> cues;  ///< kinds of these candidates' cues (Cue::kind), without "sighting"
    std::size_t sighted = 0;     ///< how many of these candidates a robot also saw by itself
    /// Number of operators' decisions about scans and about the area of the map.
    std::size_t scanDecisions = 0;
    std::size_t filed = 0;           ///< number of finds that are not discarded
    std::size_t fromCandidates = 0;  ///< how many of `filed` come from a station's candidates
    std::size_t confirmed = 0;       ///< how many of `filed` operators confirmed
};

[[nodiscard]] ReportWork workOf(const MissionState& state);

}  // namespace leitstand
