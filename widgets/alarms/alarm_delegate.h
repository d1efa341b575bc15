#pragma once

#include <QPainter>
#include <QStyledItemDelegate>

#include "core/station/alarms/alarm.h"

namespace leitstand {

/// Paints an alarm into a row: its sign, its robot's letter, its text (wrapped when long) and its age.
class AlarmDelegate final : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

/// Paints the sign of @p severity into @p box: a triangle for Attention, an octagon for Act. @p filled: the
/// alarm is standing.
void paintAlarmSign(QPainter& painter, const QRectF& box, AlarmSeverity severity, bool filled,
                    const QColor& colour, const QColor& ink);

}  // namespace leitstand
