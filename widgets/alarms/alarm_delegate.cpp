#include "widgets/alarms/alarm_delegate.h"

#include <cmath>
#include <numbers>

#include <QPolygonF>

#include "widgets/models/live/alarm_list_model.h"
#include "widgets/pane_paint.h"

namespace leitstand {
namespace {

constexpr double Row = 30.0, Sign = 18.0, Gap = 8.0;  ///< [px]

}  // namespace

void paintAlarmSign(QPainter& painter, const QRectF& box, AlarmSeverity severity, bool filled,
                    const QColor& colour, const QColor& ink) {
    QPolygonF shape;
    if (severity == AlarmSeverity::Act) {
        for (int i = 0; i < 8; ++i) {
            const double angle = (i + 0.5) * std::numbers::pi / 4.0;
            shape << box.center() + 0.5 * box.width() * QPointF(std::cos(angle), std::sin(angle));
        }
    } else {
        shape << QPointF(box.center().x(), box.top()) << box.bottomRight() << box.bottomLeft();
    }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(filled ? QBrush(colour) : QBrush(Qt::NoBrush));
    painter.drawPolygon(shape);
    const double x = box.center().x(), low = severity == AlarmSeverity::Act ? 0.72 : 0.84;
    painter.setPen(QPen(filled ? ink : colour, 2.0, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(x, box.top() + (low - 0.44) * box.height()),
                     QPointF(x, box.top() + (low - 0.18) * box.height()));
    painter.drawPoint(QPointF(x, box.top() + low * box.height()));
    painter.restore();
}

QSize AlarmDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& /*index*/) const {
    return {option.rect.width(), static_cast<int>(Row)};
}

void AlarmDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
    const auto line = index.data(AlarmListModel::LineRole).value<AlarmLine>();
    const ThemeColours& colours = coloursOf(presentTheme());
    const QRectF row(option.rect);
    painter->save();
    if (option.state.testFlag(QStyle::State_Selected)) painter->fillRect(row, colours.chosen);
    const bool stands = line.stage == AlarmStage::Standing;
    const QColor ink = toneColour(line.tone, colours);
    double x = row.left() + Gap;
    paintAlarmSign(*painter, QRectF(x, row.center().y() - 0.5 * Sign, Sign, Sign), line.severity, stands, ink,
                   colours.window);
    x += Sign + Gap;
    if (!line.face.letter.isEmpty()) {
        painter->setFont(sized(option.font, 13, true));
        painter->setPen(colours.robot(line.face.place));
        painter->drawText(QRectF(x, row.top(), 16, row.height()), Qt::AlignLeft | Qt::AlignVCenter,
                          line.face.letter);
    }
    x += 20.0;
    painter->setFont(sized(option.font, 12));
    painter->setPen(colours.muted);
    const double wide = QFontMetricsF(painter->font()).horizontalAdvance(line.since);
    const QRectF since(row.right() - Gap - wide, row.top(), wide, row.height());
    painter->drawText(since, Qt::AlignRight | Qt::AlignVCenter, line.since);
    painter->setFont(sized(option.font, 13, stands));
    painter->setPen(stands ? ink : line.tone == Tone::Muted ? colours.muted : colours.text);
    const QRectF text(x, row.top(), since.left() - Gap - x, row.height());
    painter->drawText(text, Qt::AlignLeft | Qt::AlignVCenter,
                      QFontMetricsF(painter->font()).elidedText(line.text, Qt::ElideRight, text.width()));
    painter->restore();
}

}  // namespace leitstand
