#pragma once

#include <chrono>
#include <optional>

#include <QSize>
#include <QString>

#include "app/window/shell/window_state.h"

namespace leitstand {

class MainWindow;

/// Opens @p scans in @p window, waits until all are registered and drawn, and writes a picture of the whole
/// window to @p file. Scans that cannot be read are missing in it. @p pixels: size to which the picture is
/// cut (cutToSize()); empty: it is not cut.
///
/// Returns the exit status. It is 1, with a reason on stderr, when a scan cannot be read or the picture
/// cannot be written. It is also 1, without a picture, if something is not drawn after @p patience.
[[nodiscard]] int screenshot(MainWindow& window, const Sources& scans, const QString& file,
                             const std::optional<QSize>& pixels,
                             std::chrono::milliseconds patience = std::chrono::seconds(60));

}  // namespace leitstand
