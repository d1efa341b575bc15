#pragma once

#include "core/mission/finds/candidate.h"

namespace leitstand {

// A person looked at a thing and decided that it is no victim. That holds for the thing, not for what lies
// beside it. It does not hold against a sign that was unknown then: warmth where nothing was warm, or a tag.

/// Whether @p cue belongs to @p thing, which a person ruled out. It must lie nearer than
/// CandidateSettings::ruledOut, or within CandidateSettings::ruledOutGate standard deviations of both.
[[nodiscard]] bool isOfRuledOut(const PlacedCue& cue, const CandidateThing& thing,
                                const CandidateSettings& settings);

/// Whether @p made, which is not published yet, is @p thing again, which a person ruled out. It must lie
/// nearer to it than CandidateSettings::ruledOut.
[[nodiscard]] bool isRuledOutAgain(const CandidateThing& made, const CandidateThing& thing,
                                   const CandidateSettings& settings);

}  // namespace leitstand
