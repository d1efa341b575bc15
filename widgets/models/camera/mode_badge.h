#pragma once

#include <functional>

#include <QRectF>
#include <QString>

#include "widgets/models/live/texts/mode_label.h"

namespace leitstand {

/// How a robot's mode stands over a picture.
struct ModeBadge {
    QString text;    ///< empty: the picture has no room for any
    int pixels = 0;  ///< size of its font
    QRectF box;      ///< [px]
};

/// The badge of @p mode over what is seen of a picture, @p open: as large as it fits, but on no more than a
/// fifth of it. Where that is little it stands at the upper border, in brief words, then in their first
/// letters.
/// @p sizeOf: of a text in a font of so many pixels.
[[nodiscard]] ModeBadge modeBadge(const ModeLabel& mode, const QRectF& open,
                                  const std::function<QSizeF(const QString& text, int pixels)>& sizeOf);

}  // namespace leitstand
