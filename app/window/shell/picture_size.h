#pragma once

#include <optional>

#include <QImage>
#include <QSize>

class QWidget;

namespace leitstand {

/// Returns how large a window has to be for a picture of @p pixels, on a screen of @p scale pixels per unit.
/// Without @p pixels: 1280 x 800 at any scale.
[[nodiscard]] QSize windowSizeFor(const std::optional<QSize>& pixels, double scale);

/// Returns @p picture without the pixels that come from rounding windowSizeFor() up to whole units. A window
/// that cannot be as small as requested is shown whole.
[[nodiscard]] QImage cutToSize(const QImage& picture, const std::optional<QSize>& pixels, double scale);

/// Returns @p window as a picture, cut to @p pixels (cutToSize()).
[[nodiscard]] QImage pictureOf(QWidget& window, const std::optional<QSize>& pixels);

}  // namespace leitstand
