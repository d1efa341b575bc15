#pragma once

#include <cstdint>
#include <string>

#include "core/base/time.h"
#include "core/event/candidate_sample.h"
#include "core/mission/finds/candidate_book.h"

namespace leitstand {

struct MissionState;

/// Whether a person dismisses the candidate in @p sample. A book also takes back what it doubts or what
/// became part of another candidate. That is no dismissal: it may come again.
[[nodiscard]] bool isDismissal(const CandidateSample& sample, const CandidateSettings& settings = {});

/// Returns @p candidate as a person at @p station dismisses it at @p now, or takes that back (@p dismissed
/// false).
[[nodiscard]] CandidateSample judged(CandidateSample candidate, bool dismissed, const std::string& station,
                                     Time now, const CandidateSettings& settings = {});

/// Returns the newest dismissal at @p station after the event @p after; null: there is none. Valid as long as
/// @p state.
[[nodiscard]] const CandidateSample* newestDismissal(const MissionState& state, const std::string& station,
                                                     std::uint64_t after);

}  // namespace leitstand
