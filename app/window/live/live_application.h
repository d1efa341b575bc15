#pragma once

#include <optional>

#include "app/window/shell/options.h"
#include "core/settings/ros_environment.h"

namespace leitstand {

/// Returns the options of the last station on live robots: its robots and network. Empty: there was none.
[[nodiscard]] std::optional<Options> lastOptions();

/// Runs the station on live robots as @p options request: on robots that are there, or on simulated ones that
/// it starts. @p environment does not apply to simulated robots. Needs a QApplication. Returns the exit
/// status.
[[nodiscard]] int runLive(const Options& options, const RosEnvironment& environment = {});

}  // namespace leitstand
