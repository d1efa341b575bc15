#pragma once

#include "core/mission/state/decision.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

/// Adds @p decision as the newest one and applies it. An undo changes which earlier decisions are in effect.
/// An undo of an event that is no decision, or a pose of an unknown key scan, adds a remark.
void decide(MissionState& state, Decision decision);

/// Computes which of MissionState::decisions are undone, and everything that results from the others: finds,
/// key scans, loops, bodies of robots in scans, notes and the area of the map.
void reconsider(MissionState& state);

/// Adds a remark about the event with the sequence @p sequence.
void remark(MissionState& state, std::uint64_t sequence, std::string text);

}  // namespace leitstand
