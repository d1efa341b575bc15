#pragma once

#include "core/base/time.h"

namespace leitstand {

class ReviewLog;
struct ReviewIndex;

/// Returns the first moment at which each pane for the first robot of @p log shows something: both cameras,
/// virtual scan, strip, and the map. Leaves out panes for which the mission has nothing in the first half of
/// its recorded time. Returns the end of a mission with a map but no robots, such as a merged one. @p index:
/// complete, except for ReviewIndex::opensAt.
[[nodiscard]] Time openingOf(ReviewLog& log, const ReviewIndex& index);

}  // namespace leitstand
