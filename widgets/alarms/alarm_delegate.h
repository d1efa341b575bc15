#pragma once

#include <QPainter>
#include <QStyledItemDelegate>

#include "core/station/alarms/alarm.h"

namespace leitstand {

/// Paints an alarm in a row: its sign, its robot's letter, its text (wrapped if long) and its age.
class AlarmDelegate final : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

/// Paints the sign of @p severity into @p box: a triangle for Attention, an octagon for Act, each with an
/// exclamation mark. @p filled (for active alarms): the shape is filled with @p colour and the mark is drawn
/// in @p ink. Otherwise both are lines in @p colour.
void paintAlarmSign(QPainter& painter, const QRectF& box, AlarmSeverity severity, bool filled,
                    const QColor& colour, const QColor& ink);

}  // namespace leitstand
