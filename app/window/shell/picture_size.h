#pragma once

#include <optional>

#include <QImage>
#include <QSize>

class QWidget;

namespace leitstand {

/// How large a window has to be for a picture of @p pixels, on a screen of @p scale pixels to its unit; none
/// are asked for: 1280 x 800 at any scale.
[[nodiscard]] QSize windowSizeFor(const std::optional<QSize>& pixels, double scale);

/// @p picture without what is there by rounding a window of windowSizeFor() up to whole units. A window that
/// cannot be as small as asked for is shown whole.
[[nodiscard]] QImage cutToSize(const QImage& picture, const std::optional<QSize>& pixels, double scale);

/// The window as a picture, whose size was asked for.
[[nodiscard]] QImage pictureOf(QWidget& window, const std::optional<QSize>& pixels);

}  // namespace leitstand
