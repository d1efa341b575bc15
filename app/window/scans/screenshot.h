#pragma once

#include <chrono>
#include <optional>

#include <QSize>
#include <QString>

#include "app/window/shell/window_state.h"

namespace leitstand {

class MainWindow;

/// Opens @p scans in @p window, waits until all are registered and drawn, and writes a picture of the whole
/// window to @p file. The picture is cut to @p pixels when they are given (cutToSize()), and shows what could
/// be read. Returns the exit status: 1, after printing the reason on stderr, when a scan could not be read,
/// the picture not be written, or something is missing after @p patience.
[[nodiscard]] int screenshot(MainWindow& window, const Sources& scans, const QString& file,
                             const std::optional<QSize>& pixels,
                             std::chrono::milliseconds patience = std::chrono::seconds(60));

}  // namespace leitstand
