#include "widgets/alarms/alarm_delegate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QAbstractItemView>
#include <QPolygonF>
#include <QTextLayout>

#include "widgets/models/live/alarm_list_model.h"
#include "widgets/painting/pane_paint.h"

namespace leitstand {
namespace {

constexpr double Row = 30.0, Sign = 18.0, Gap = 8.0, Letter = 20.0;  ///< [px]
constexpr int MostLines = 4;                                         ///< the tooltip shows the whole text

/// Positions of the parts of a row, from its left edge.
struct RowParts {
    double text = 0.0, since = 0.0;  ///< where they begin [px]
    QStringList lines;               ///< of the text; the first line ends before the time
};

QFont textFont(const QStyleOptionViewItem& option, const AlarmLine& line) {
    return sized(option.font, 13, line.stage == AlarmStage::Standing);
}

/// Lays out a row @p width wide [px]. A long text wraps instead of being cut: its end may hold numbers.
RowParts partsOf(const AlarmLine& line, const QStyleOptionViewItem& option, double width) {
    RowParts parts;
    parts.text = Gap + Sign + Gap + Letter;
    const QFont font = textFont(option, line);
    const QFontMetricsF metrics(font);
    parts.since =
        width - Gap - std::ceil(QFontMetricsF(sized(option.font, 12)).horizontalAdvance(line.since));
    QTextLayout layout(line.text, font);
    QTextOption wrapping;
    wrapping.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(wrapping);
    layout.beginLayout();
    for (int i = 0; i < MostLines; ++i) {
        QTextLine one = layout.createLine();
        if (!one.isValid()) break;
        const double room = std::max(20.0, (i == 0 ? parts.since : width) - Gap - parts.text);
        one.setLineWidth(room);
        const QString rest = line.text.mid(one.textStart());
        parts.lines += i + 1 == MostLines ? metrics.elidedText(rest, Qt::ElideRight, room)
                                          : rest.left(one.textLength()).trimmed();
    }
    layout.endLayout();
    return parts;
}

double lineHeight(const QStyleOptionViewItem& option, const AlarmLine& line) {
    return std::ceil(QFontMetricsF(textFont(option, line)).height());
}

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

QSize AlarmDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const auto line = index.data(AlarmListModel::LineRole).value<AlarmLine>();
    const auto* const view = qobject_cast<const QAbstractItemView*>(option.widget);
    const int width = view == nullptr ? option.rect.width() : view->viewport()->width();
    const auto more = std::max<qsizetype>(0, partsOf(line, option, width).lines.size() - 1);
    return {width, static_cast<int>(Row + static_cast<double>(more) * lineHeight(option, line))};
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
    const RowParts parts = partsOf(line, option, row.width());
    double x = row.left() + Gap;
    paintAlarmSign(*painter, QRectF(x, row.top() + 0.5 * (Row - Sign), Sign, Sign), line.severity, stands,
                   ink, colours.window);
    x += Sign + Gap;
    if (!line.face.letter.isEmpty()) {
        painter->setFont(sized(option.font, 13, true));
        painter->setPen(colours.robot(line.face.place));
        painter->drawText(QRectF(x, row.top(), 16, Row), Qt::AlignLeft | Qt::AlignVCenter, line.face.letter);
    }
    painter->setFont(sized(option.font, 12));
    painter->setPen(colours.muted);
    const double since = row.left() + parts.since;
    painter->drawText(QRectF(since, row.top(), row.right() - Gap - since + 1.0, Row),
                      Qt::AlignLeft | Qt::AlignVCenter, line.since);
    painter->setFont(textFont(option, line));
    painter->setPen(stands ? ink : line.tone == Tone::Muted ? colours.muted : colours.text);
    x = row.left() + parts.text;
    double y = row.top();
    for (const QString& text : parts.lines) {
        painter->drawText(QRectF(x, y, row.right() - x, Row), Qt::AlignLeft | Qt::AlignVCenter, text);
        y += lineHeight(option, line);
    }
    painter->restore();
}

}  // namespace leitstand
