#include "widgets/timeline/mark_glyph.h"

#include <algorithm>

#include <QFontMetricsF>
#include <QPainterPath>

#include "widgets/painting/pane_paint.h"

namespace leitstand {
namespace {

constexpr double Half = 6.5;  ///< of a shape's width [px]

QPolygonF polygon(const QPointF& middle, std::initializer_list<QPointF> corners) {
    QPolygonF shape;
    for (const QPointF& corner : corners) shape << middle + Half * corner;
    return shape;
}

}  // namespace

void paintMark(QPainter& painter, const TimelineGlyph& glyph, const QPointF& middle, const QFont& font) {
    const ThemeColours& colours = coloursOf(presentTheme());
    const bool discarded = glyph.tone == Tone::Muted;
    const bool find = glyph.shape == MarkShape::Disc || glyph.shape == MarkShape::Drop;
    const QColor ink = find && !discarded ? colours.select : toneColour(glyph.tone, colours);
    const QRectF box(middle.x() - Half, middle.y() - Half, 2 * Half, 2 * Half);
    painter.setPen(QPen(colours.strip, 1.5));  // separates marks that overlap
    painter.setBrush(ink);
    switch (glyph.shape) {
        case MarkShape::Disc: {
            painter.setFont(sized(font, 11, true));
            // Wider for a name of more than one digit, so that it fits.
            const double text = QFontMetricsF(painter.font()).horizontalAdvance(glyph.letter);
            const double wider = std::max(2.0, text / 2 + 4.0 - Half);
            const QRectF disc = box.adjusted(-wider, -2, wider, 2);
            painter.drawRoundedRect(disc, disc.height() / 2, disc.height() / 2);
            painter.setPen(colours.window);
            painter.drawText(disc, Qt::AlignCenter, glyph.letter);
            break;
        }
        case MarkShape::Drop: {  // points down to its moment; hollow, since it is not confirmed yet
            QPainterPath drop(middle + QPointF(0, Half + 4));
            drop.quadTo(middle + QPointF(-Half - 3, 0), middle + QPointF(-Half + 1, -Half + 1));
            drop.quadTo(middle + QPointF(0, -Half - 5), middle + QPointF(Half - 1, -Half + 1));
            drop.quadTo(middle + QPointF(Half + 3, 0), middle + QPointF(0, Half + 4));
            painter.setPen(QPen(ink, 1.5));
            painter.setBrush(colours.strip);
            painter.drawPath(drop);
            painter.setFont(sized(font, 10, true));
            painter.drawText(box.adjusted(-2, -3, 2, 0), Qt::AlignCenter, glyph.letter);
            break;
        }
        case MarkShape::Triangle:
            painter.drawPolygon(polygon(middle, {{0, -1}, {1.1, 0.9}, {-1.1, 0.9}}));
            break;
        case MarkShape::Square:
            painter.drawRect(box.adjusted(1, 1, -1, -1));
            break;
        case MarkShape::Diamond:
            painter.drawPolygon(polygon(middle, {{0, -1.1}, {1.1, 0}, {0, 1.1}, {-1.1, 0}}));
            break;
        case MarkShape::Arrow:
            painter.drawPolygon(polygon(
                middle, {{-1.1, -0.4}, {0.1, -0.4}, {0.1, -1}, {1.1, 0}, {0.1, 1}, {0.1, 0.4}, {-1.1, 0.4}}));
            break;
        case MarkShape::Bar:
            painter.drawRect(QRectF(middle.x() - 2.0, middle.y() - Half, 4.0, 2 * Half));
            break;
        case MarkShape::Cross:
            painter.setPen(QPen(ink, 2.5));
            painter.drawLine(box.topLeft() + QPointF(2, 2), box.bottomRight() - QPointF(2, 2));
            painter.drawLine(box.bottomLeft() + QPointF(2, -2), box.topRight() + QPointF(-2, 2));
            break;
        case MarkShape::Ring:
            painter.setBrush(colours.strip);
            painter.setPen(QPen(ink, 2.0));
            painter.drawEllipse(box.adjusted(1.5, 1.5, -1.5, -1.5));
            break;
        case MarkShape::Flag:
            painter.setPen(QPen(ink, 1.5));
            painter.drawLine(QPointF(middle.x(), box.top()), QPointF(middle.x(), box.bottom() + 6));
            painter.setPen(Qt::NoPen);
            painter.drawPolygon(
                QPolygonF({QPointF(middle.x(), box.top()), QPointF(middle.x() + 8, box.top() + 4),
                           QPointF(middle.x(), box.top() + 8)}));
            break;
    }
}

}  // namespace leitstand
