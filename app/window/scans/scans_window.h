#pragma once

#include "app/window/shell/window_state.h"

namespace leitstand {

/// Opens a window with @p scans, which looks as @p state describes. The window is created again when another
/// language is chosen. When it is closed, it is deleted and its state is remembered.
void showScansWindow(const Sources& scans, const WindowState& state);

}  // namespace leitstand
