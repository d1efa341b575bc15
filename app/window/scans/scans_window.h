#pragma once

#include "app/window/shell/window_state.h"

namespace leitstand {

/// Opens a window on @p scans that looks as @p state says, is made anew when another language is chosen, and
/// goes when it is closed; what it changed of @p state is remembered then.
void showScansWindow(const Sources& scans, const WindowState& state);

}  // namespace leitstand
