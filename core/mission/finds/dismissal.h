#pragma once

#include <cstdint>
#include <string>

#include "core/base/time.h"
#include "core/event/candidate_sample.h"
#include "core/mission/finds/candidate_book.h"

namespace leitstand {

struct MissionState;

/// Whether a person dismissed the candidate in @p sample. A CandidateBook also takes back candidates that it
/// doubts, or that became part of another one. Such candidates are not dismissed: they may come again.
[[nodiscard]] bool isDismissal(const CandidateSample& sample, const CandidateSettings& settings = {});

/// Returns @p candidate as a person at @p station dismisses it at @p now. With @p dismissed false, the person
/// takes the dismissal back.
[[nodiscard]] CandidateSample judged(CandidateSample candidate, bool dismissed, const std::string& station,
                                     Time now, const CandidateSettings& settings = {});

/// Returns the newest dismissal at @p station after the event with sequence @p after; null: there is none.
/// The pointer is valid as long as @p state.
[[nodiscard]] const CandidateSample* newestDismissal(const MissionState& state, const std::string& station,
                                                     std::uint64_t after);

}  // namespace leitstand
