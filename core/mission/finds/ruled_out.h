#pragma once

#include "core/mission/finds/candidate.h"

namespace leitstand {

// A person looked at a thing and decided that it is no victim. That holds for the thing, not for what lies
// beside it. It does not hold against a sign that was unknown then: warmth where nothing was warm, or a tag.

/// Whether @p cue belongs to @p thing, which a person ruled out. It does if it is nearer than
/// CandidateSettings::ruledOut, or within CandidateSettings::ruledOutGate standard deviations of both.
[[nodiscard]] bool isOfRuledOut(const PlacedCue& cue, const CandidateThing& thing,
                                const CandidateSettings& settings);

/// Whether the unpublished @p made is the same as @p thing, which a person ruled out. It is if it lies nearer
/// than CandidateSettings::ruledOut.
[[nodiscard]] bool isRuledOutAgain(const CandidateThing& made, const CandidateThing& thing,
                                   const CandidateSettings& settings);

}  // namespace leitstand
