#pragma once

#include <functional>

#include <QRectF>
#include <QString>

#include "widgets/models/live/texts/mode_label.h"

namespace leitstand {

/// The badge of a robot's mode over a picture.
struct ModeBadge {
    QString text;    ///< empty: the picture has no room for any
    int pixels = 0;  ///< size of its font
    QRectF box;      ///< [px]
};

/// Returns the badge of @p mode over @p open, the visible part of a picture. It is as large as fits, but
/// covers a fifth of that at most. When that is little, it lies at the upper border in brief words, otherwise
/// in their initials. @p sizeOf: size of a text in a font of so many pixels.
[[nodiscard]] ModeBadge modeBadge(const ModeLabel& mode, const QRectF& open,
                                  const std::function<QSizeF(const QString& text, int pixels)>& sizeOf);

}  // namespace leitstand
