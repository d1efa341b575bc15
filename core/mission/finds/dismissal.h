#pragma once

#include <cstdint>
#include <string>

#include "core/base/time.h"
#include "core/event/candidate_sample.h"
#include "core/mission/finds/candidate_book.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

/// Whether a person says in @p sample that it is none. A book takes back what it doubts, or what became part
/// of another candidate: nobody dismissed that, and it may come again.
[[nodiscard]] bool isDismissal(const CandidateSample& sample, const CandidateSettings& settings = {});

/// @p candidate as a person at @p station dismisses it at @p now, or (@p dismissed false) takes that back.
[[nodiscard]] CandidateSample judged(CandidateSample candidate, bool dismissed, const std::string& station,
                                     Time now, const CandidateSettings& settings = {});

/// The newest dismissal at @p station that is newer than the event @p after; null: there is none. Stays valid
/// as long as @p state.
[[nodiscard]] const CandidateSample* newestDismissal(const MissionState& state, const std::string& station,
                                                     std::uint64_t after);

}  // namespace leitstand
