#pragma once

#include "app/window/shell/options.h"

namespace leitstand {

/// Whether @p options ask for the review of a mission: one source, which holds the events of a station.
[[nodiscard]] bool wantsReview(const Options& options);

/// The review of the mission that @p options name. Needs a QApplication. Returns the exit status.
[[nodiscard]] int runReview(const Options& options);

}  // namespace leitstand
