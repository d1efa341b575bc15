#pragma once

#include <vector>

#include <QString>

#include "core/mission/finds/find_moves.h"

namespace leitstand {

/// "scans were registered anew": why finds moved, after "since".
[[nodiscard]] QString causeText(FindMove::Cause cause);
/// "moved 0.32 m at 12:03:05, since scans were registered anew".
[[nodiscard]] QString movedText(const FindMove& move);
/// What moved at once, as a message: "V1 0.32 m, V2 0.11 m moved, since a loop was closed"; empty: nothing.
[[nodiscard]] QString movesText(const std::vector<FindMove>& moves);

}  // namespace leitstand
