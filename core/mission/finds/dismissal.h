#pragma once

#include <cstdint>
#include <string>

#include "core/base/time.h"
#include "core/event/candidate_sample.h"
#include "core/mission/finds/candidate_book.h"

namespace leitstand {

struct MissionState;

/// Whether a person dismissed the candidate in @p sample. A CandidateBook also withdraws candidates that it
/// doubts, or that became part of another candidate. These are not dismissed: they may appear again.
[[nodiscard]] bool isDismissal(const CandidateSample& sample, const CandidateSettings& settings = {});

/// Returns @p candidate as a person at @p station dismisses it at @p now. If @p dismissed is false, the
/// person revokes the dismissal.
[[nodiscard]] CandidateSample judged(CandidateSample candidate, bool dismissed, const std::string& station,
                                     Time now, const CandidateSettings& settings = {});

/// Returns the newest dismissal at @p station after the event with sequence @p after; null: there is none.
/// The pointer is valid as long as @p state.
[[nodiscard]] const CandidateSample* newestDismissal(const MissionState& state, const std::string& station,
                                                     std::uint64_t after);

}  // namespace leitstand
