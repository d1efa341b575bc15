#include "widgets/map_view/overlays/floor/legend_squares.h"

#include <QFontMetrics>
#include <QPainter>
#include <QPainterPath>

#include "widgets/map_view/overlays/overlay_style.h"

namespace leitstand {

QRect paintLegendSquares(QPainter& painter, const std::vector<LegendSquare>& squares, QSize size,
                         const QRect& below, const OverlayStyle& style) {
    constexpr int Margin = 12, Padding = 9, Square = 14, Gap = 6, Space = 14, Slack = 2;
    painter.setFont(style.font);
    const QFontMetrics metrics = painter.fontMetrics();
    const int height = metrics.height() + 10;
    const int bottom = below.isNull() ? size.height() - Margin : below.top() - Gap;
    int width = 2 * Padding - Space;
    for (const LegendSquare& one : squares)
        width += (one.fill ? Square + Gap : 0) + metrics.horizontalAdvance(one.text) + Slack + Space;
    const QRect box(Margin, bottom - height, width, height);
    paintPanel(painter, box, style);
    int x = box.left() + Padding;
    for (const LegendSquare& one : squares) {
        if (one.fill) {
            const QRect square(x, box.center().y() - Square / 2 + 1, Square, Square);
            QPainterPath path;
            path.addRect(square);
            one.fill(painter, path);
            painter.setBrush(Qt::NoBrush);
            painter.setPen(asColour(style.colours.muted));
            painter.drawRect(square);
            x += Square + Gap;
        }
        painter.setPen(asColour(style.colours.text));
        const int advance = metrics.horizontalAdvance(one.text) + Slack;
        painter.drawText(QRect(x, box.top(), advance, box.height()), Qt::AlignVCenter, one.text);
        x += advance + Space;
    }
    return box;
}

}  // namespace leitstand
