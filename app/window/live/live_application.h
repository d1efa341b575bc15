#pragma once

#include <optional>

#include "app/window/shell/options.h"

namespace leitstand {

/// As the station on live robots was opened last; nothing when it never was.
[[nodiscard]] std::optional<Options> lastOptions();

/// The station on live robots, as @p options ask: on robots that are there, or with simulated ones started
/// beside it. Needs a QApplication. Returns the exit status.
[[nodiscard]] int runLive(const Options& options);

}  // namespace leitstand
