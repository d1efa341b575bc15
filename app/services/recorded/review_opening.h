#pragma once

#include "core/base/time.h"

namespace leitstand {

class ReviewLog;
struct ReviewIndex;

/// Returns the first moment at which each pane for the first robot of @p log shows something: both cameras,
/// virtual scan, strip, and the map. Panes for which the mission has nothing in the first half of its
/// recorded time are ignored. For a mission with a map but no robots, such as a merged one, returns the end.
/// @p index: complete, except for ReviewIndex::opensAt.
[[nodiscard]] Time openingOf(ReviewLog& log, const ReviewIndex& index);

}  // namespace leitstand
