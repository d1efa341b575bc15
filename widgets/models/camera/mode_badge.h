#pragma once

#include <functional>

#include <QRectF>
#include <QString>

#include "widgets/models/live/texts/mode_label.h"

namespace leitstand {

/// The badge of a robot's mode over a picture.
struct ModeBadge {
    QString text;    ///< empty: the picture has no room for a badge
    int pixels = 0;  ///< size of its font
    QRectF box;      ///< [px]
};

/// Returns the badge of @p mode over @p open, the visible part of a picture. Its font is as large as
/// possible, but the badge covers at most a fifth of @p open. If even the smallest font is too large, the
/// badge moves to the upper border. There it has the full text, else the brief one, else the initials of
/// that. @p sizeOf: returns the size of a text in a font of so many pixels.
[[nodiscard]] ModeBadge modeBadge(const ModeLabel& mode, const QRectF& open,
                                  const std::function<QSizeF(const QString& text, int pixels)>& sizeOf);

}  // namespace leitstand
