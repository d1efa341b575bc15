#pragma once

#include <chrono>
#include <optional>

#include <QSize>
#include <QString>

#include "app/window/shell/window_state.h"

namespace leitstand {

class MainWindow;

/// Opens @p scans in @p window, waits until all are registered and drawn, and writes a picture of the whole
/// window to @p file, cut to @p pixels when they were asked for (cutToSize()). Returns the exit status: 1,
/// after telling why on stderr, when a scan could not be read, the picture not be written, or something is
/// missing after @p patience. The picture shows what could be read.
[[nodiscard]] int screenshot(MainWindow& window, const Sources& scans, const QString& file,
                             const std::optional<QSize>& pixels,
                             std::chrono::milliseconds patience = std::chrono::seconds(60));

}  // namespace leitstand
