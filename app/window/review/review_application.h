#pragma once

#include "app/window/shell/options.h"

namespace leitstand {

/// Returns whether @p options request the review of a mission: their only source can be reviewed
/// (isReviewable()), and its scans shall not be registered again.
[[nodiscard]] bool wantsReview(const Options& options);

/// Runs the review of the mission in @p options. Needs a QApplication. Returns the exit status.
[[nodiscard]] int runReview(const Options& options);

}  // namespace leitstand
