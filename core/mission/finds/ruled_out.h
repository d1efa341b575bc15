#pragma once

#include "core/mission/finds/candidate.h"

namespace leitstand {

// A person has looked at a thing and said that it is no victim. That holds for the thing, not for what lies
// beside it, and not where something is felt or read that nobody knew then: warmth where nothing was warm, a
// tag.

/// Whether @p cue is of @p thing, which a person ruled out: nearer to it than CandidateSettings::ruledOut, or
/// within the deviations of both.
[[nodiscard]] bool isOfRuledOut(const PlacedCue& cue, const CandidateThing& thing,
                                const CandidateSettings& settings);

/// Whether @p made, of which nobody was told yet, is @p thing again, which a person ruled out: its cues lay
/// about that.
[[nodiscard]] bool isRuledOutAgain(const CandidateThing& made, const CandidateThing& thing,
                                   const CandidateSettings& settings);

}  // namespace leitstand
