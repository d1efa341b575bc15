#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/time.h"
#include "core/event/candidate_sample.h"
#include "core/event/find_sample.h"

namespace leitstand {

/// A victim or another find, from the newest decision about it that is not undone.
struct FindState {
    std::uint64_t sequence = 0;  ///< sequence of that decision
    std::uint64_t filed = 0;     ///< sequence of the first decision about it that is not undone
    FindSample victim;
};

/// The first report of a candidate: which robot, and whether it was driving itself. A find made from the
/// candidate is scored by this, no matter when it is filed.
struct FirstReport {
    Time stamp{};                    ///< when it was reported, station's clock
    std::string robot;               ///< empty: unknown
    std::optional<bool> autonomous;  ///< whether it was driving itself; empty: unknown
};

/// A candidate: what the station believes it has found, from its newest sample.
struct CandidateState {
    std::uint64_t sequence = 0;  ///< sequence of its newest sample
    std::uint64_t first = 0;     ///< sequence of the first sample with its id
    FirstReport firstReport;     ///< from that first sample
    CandidateSample candidate;
};

}  // namespace leitstand
