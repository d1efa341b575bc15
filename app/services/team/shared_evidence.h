#pragma once

#include "core/event/event.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

/// @p sample as it is for other stations: where its evidence and cues stand in this log says nothing in
/// theirs, and becomes 0.
[[nodiscard]] Sample forOthers(Sample sample);

/// @p sample of another station with the sequences of evidence and cues that @p mission has of the same find
/// or candidate, as far as it does. Whether there were any.
[[nodiscard]] bool takeOurSequences(Sample& sample, const MissionState& mission);

}  // namespace leitstand
