#pragma once

#include "core/base/time.h"

namespace leitstand {

class ReviewLog;
struct ReviewIndex;

/// Returns the first moment at which each pane on the first robot of @p log shows something, as far as the
/// mission has it. Panes are both cameras, virtual scan, strip, and the map. Does not wait for what began
/// after half of the recorded time. Returns the end where there is a map without robots, as in merged
/// missions. @p index: all of it but this.
[[nodiscard]] Time openingOf(ReviewLog& log, const ReviewIndex& index);

}  // namespace leitstand
