#pragma once

#include "core/event/sample.h"

namespace leitstand {

struct MissionState;

/// Returns @p sample for other stations: the sequences of its evidence and cues mean nothing in their logs,
/// and become 0.
[[nodiscard]] Sample forOthers(Sample sample);

/// Gives @p sample of another station the sequences of evidence and cues that @p mission has of the same find
/// or candidate, as far as known. Returns whether there were any.
[[nodiscard]] bool takeOurSequences(Sample& sample, const MissionState& mission);

}  // namespace leitstand
