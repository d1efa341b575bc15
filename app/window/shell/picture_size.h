#pragma once

#include <optional>

#include <QImage>
#include <QSize>

class QWidget;

namespace leitstand {

/// Returns the size of a window [Qt's units] whose picture has @p pixels, or slightly more, on a screen with
/// @p scale pixels per unit. Without @p pixels: 1280 x 800 at any scale.
[[nodiscard]] QSize windowSizeFor(const std::optional<QSize>& pixels, double scale);

/// Returns @p picture cut to @p pixels, which windowSizeFor() rounds up to whole units. Without @p pixels
/// nothing is cut. A side is not cut if the window could not become as small as requested.
[[nodiscard]] QImage cutToSize(const QImage& picture, const std::optional<QSize>& pixels, double scale);

/// Returns @p window as a picture, cut to @p pixels (cutToSize()).
[[nodiscard]] QImage pictureOf(QWidget& window, const std::optional<QSize>& pixels);

}  // namespace leitstand
