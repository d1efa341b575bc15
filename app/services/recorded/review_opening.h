#pragma once

#include "core/base/time.h"

namespace leitstand {

class ReviewLog;
struct ReviewIndex;

/// The first moment at which each pane that shows the first robot of @p log has something, as far as the
/// mission has it: both cameras, virtual scan, strip, and the map. What began only after half of what was
/// recorded is not waited for. Where there is a map without robots, as merged ones are, the end. @p index:
/// all of it but this.
[[nodiscard]] Time openingOf(ReviewLog& log, const ReviewIndex& index);

}  // namespace leitstand
