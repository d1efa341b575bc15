#pragma once

#include "core/event/sample.h"

namespace leitstand {

struct MissionState;

/// Returns @p sample as other stations receive it: the sequences of its evidence and cues are 0, since they
/// have no meaning in other logs.
[[nodiscard]] Sample forOthers(Sample sample);

/// Sets the sequences of evidence and cues in @p sample, which came from another station, as far as
/// @p mission knows them for the same find or candidate. Returns whether any was set.
[[nodiscard]] bool takeOurSequences(Sample& sample, const MissionState& mission);

}  // namespace leitstand
