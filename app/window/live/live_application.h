#pragma once

#include <optional>

#include "app/window/shell/options.h"

namespace leitstand {

/// Returns the options of the last station on live robots. Nothing when there was none.
[[nodiscard]] std::optional<Options> lastOptions();

/// Runs the station on live robots for @p options: on robots that are there, or with simulated ones started
/// beside it. Needs a QApplication. Returns the exit status.
[[nodiscard]] int runLive(const Options& options);

}  // namespace leitstand
