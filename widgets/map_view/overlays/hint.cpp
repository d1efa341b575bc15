#include "widgets/map_view/overlays/hint.h"

#include <algorithm>

#include <QFontMetrics>
#include <QPainter>

#include "widgets/map_view/overlays/overlay_style.h"

namespace leitstand {

void paintHint(QPainter& painter, const QString& text, QSize size, const OverlayStyle& style) {
    constexpr int Margin = 10, Padding = 8, ToolColumn = 56;
    painter.setFont(style.font);
    const QRect room(ToolColumn, Margin, std::max(60, size.width() - 2 * ToolColumn), size.height() / 2);
    const QRect lines = painter.fontMetrics().boundingRect(room.adjusted(Padding, 0, -Padding, 0),
                                                           Qt::AlignHCenter | Qt::TextWordWrap, text);
    QRect box = lines.adjusted(-Padding, -4, Padding, 4);
    box.moveTop(Margin);
    paintPanel(painter, box, style);
    painter.setPen(asColour(style.colours.text));
    painter.drawText(box, Qt::AlignCenter | Qt::TextWordWrap, text);
}

}  // namespace leitstand
