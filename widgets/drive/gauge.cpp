#include "widgets/drive/gauge.h"

namespace leitstand {

void paintCaption(QPainter& painter, const QRectF& line, const QString& text, const QColor& colour) {
    painter.setFont(sized(painter.font(), CaptionSize));
    painter.setPen(colour);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetricsF(painter.font()).elidedText(text, Qt::ElideRight, line.width()));
}

double paintFigure(QPainter& painter, const QRectF& line, const Figure& figure, int pixels,
                   const ThemeColours& colours) {
    // A number without its unit may be misread: the number shrinks before the unit goes.
    const double unit = QFontMetricsF(sized(painter.font(), CaptionSize)).horizontalAdvance(figure.unit);
    painter.setFont(
        fitted(painter.font(), figure.value, line.width() - (unit > 0.0 ? unit + 4.0 : 0.0), pixels, 11));
    const QFontMetricsF large(painter.font());
    const double baseline = line.center().y() + 0.36 * pixels;
    painter.setPen(toneColour(figure.tone, colours));
    painter.drawText(QPointF(line.left(), baseline), figure.value);
    double end = line.left() + large.horizontalAdvance(figure.value);
    painter.setFont(sized(painter.font(), CaptionSize));
    if (end + 4.0 + unit > line.right() + 0.5) return end;
    painter.setPen(colours.muted);
    painter.drawText(QPointF(end + 4.0, baseline), figure.unit);
    return end + 4.0 + unit;
}

}  // namespace leitstand
