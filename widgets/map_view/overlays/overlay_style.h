#pragma once

#include <QColor>
#include <QFont>
#include <QLocale>
#include <QPainter>
#include <QRect>
#include <QString>

#include "widgets/map_view/scene/points/map_colours.h"

namespace leitstand {

struct ThemeColours;

/// The style of text and lines over the map.
struct OverlayStyle {
    MapColours colours;
    const ThemeColours* window = nullptr;  ///< colours of robots and tones; never null
    QFont font;
    QLocale locale;
};

[[nodiscard]] inline QColor asColour(Rgba colour) {
    return {colour.r, colour.g, colour.b, colour.a};
}

/// Paints the surface below text over the map.
inline void paintPanel(QPainter& painter, const QRectF& box, const OverlayStyle& style) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(asColour(style.colours.panel));
    painter.drawRoundedRect(box, 4, 4);
}

/// Returns @p value with @p decimals digits after the point, as @p locale writes it, with a real minus sign.
[[nodiscard]] inline QString numberText(double value, int decimals, const QLocale& locale) {
    return locale.toString(value, 'f', decimals).replace(QLatin1Char('-'), QChar(0x2212));
}

}  // namespace leitstand
