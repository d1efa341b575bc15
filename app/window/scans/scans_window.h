#pragma once

#include "app/window/shell/window_state.h"

namespace leitstand {

/// Opens a window for @p scans with the state @p state. The window is created again when another language is
/// selected. When it is closed, it is deleted and its state is stored.
void showScansWindow(const Sources& scans, const WindowState& state);

}  // namespace leitstand
