#pragma once

#include <functional>

#include <QRectF>
#include <QString>

#include "widgets/models/live/texts/mode_label.h"

namespace leitstand {

/// The badge of a robot's mode over a picture.
struct ModeBadge {
    QString text;    ///< empty: there is no space for a badge in the picture
    int pixels = 0;  ///< size of its font
    QRectF box;      ///< [px]
};

/// Returns the badge of @p mode over @p open, the visible part of a picture. Its font is as large as
/// possible, but the badge covers at most a fifth of @p open. If even the smallest font is too large, the
/// badge is at the upper edge. There it has the full text; if that is too wide, the short text, or the
/// initials of that. @p sizeOf: returns the size of a text in a font with so many pixels.
[[nodiscard]] ModeBadge modeBadge(const ModeLabel& mode, const QRectF& open,
                                  const std::function<QSizeF(const QString& text, int pixels)>& sizeOf);

}  // namespace leitstand
