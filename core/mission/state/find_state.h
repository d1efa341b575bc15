#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/time.h"
#include "core/event/candidate_sample.h"
#include "core/event/find_sample.h"

namespace leitstand {

/// A victim or other find, by the newest decision on it that is not undone.
struct FindState {
    std::uint64_t sequence = 0;  ///< of that decision
    std::uint64_t filed = 0;     ///< sequence of the first decision on it that is not undone
    FindSample victim;
};

/// The first report of a candidate: its robot, and whether that robot drove itself then. A find made from the
/// candidate counts accordingly, however late it is filed.
struct FirstReport {
    Time stamp{};                    ///< station's clock
    std::string robot;               ///< empty: unknown
    std::optional<bool> autonomous;  ///< it drove itself; empty: unknown
};

/// A candidate: what the station believes to have found, by its newest sample.
struct CandidateState {
    std::uint64_t sequence = 0;  ///< of the newest
    std::uint64_t first = 0;     ///< sequence of the first of this id
    FirstReport firstReport;     ///< by that event
    CandidateSample candidate;
};

}  // namespace leitstand
