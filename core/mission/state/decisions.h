#pragma once

#include "core/mission/state/decision.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

/// Adds @p decision as the newest and applies it; an undo changes the effect of earlier ones. A key that
/// makes no sense (an undo of what is no decision) becomes a remark.
void decide(MissionState& state, Decision decision);

/// Computes from MissionState::decisions which of them are undone, and all that follows from the others:
/// victims, key scans, notes and the area of the map.
void reconsider(MissionState& state);

/// Adds a remark about the event of @p sequence.
void remark(MissionState& state, std::uint64_t sequence, std::string text);

}  // namespace leitstand
