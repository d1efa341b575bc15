#pragma once

#include <vector>

#include <QString>

#include "core/mission/finds/find_moves.h"

namespace leitstand {

/// Returns why finds moved, in words that follow "since": "a loop was closed".
[[nodiscard]] QString causeText(FindMove::Cause cause);
/// Returns "moved 0.32 m at 12:03:05, since a loop was closed".
[[nodiscard]] QString movedText(const FindMove& move);
/// Returns a message about finds that moved at the same time: "V1 0.32 m, V2 0.11 m moved, since a loop was
/// closed"; empty without @p moves.
[[nodiscard]] QString movesText(const std::vector<FindMove>& moves);

}  // namespace leitstand
