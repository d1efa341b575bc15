#pragma once

#include <optional>

#include "app/window/shell/options.h"
#include "core/settings/ros_environment.h"

namespace leitstand {

/// Returns options that open the last station on live robots again: its robots and network. Empty: there was
/// none.
[[nodiscard]] std::optional<Options> lastOptions();

/// Runs the station on live robots according to @p options: on existing robots, or on simulated ones that it
/// starts. @p environment is not used for simulated robots. Needs a QApplication. Returns the exit status.
[[nodiscard]] int runLive(const Options& options, const RosEnvironment& environment = {});

}  // namespace leitstand
