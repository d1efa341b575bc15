#pragma once

#include <QString>

#include "core/mission/state/undo.h"

namespace leitstand {

/// Returns a decision about the map in words that follow "Undo": "scan 12 set aside", "3 scans set aside",
/// "what belongs into the map".
[[nodiscard]] QString decisionText(const MapDecision& decision);
/// Returns what was undone or redone in words for the operator: "scan 12 set aside", "V1".
[[nodiscard]] QString undoneText(const UndoneThing& thing);

}  // namespace leitstand
