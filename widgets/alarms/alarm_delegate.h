#pragma once

#include <QPainter>
#include <QStyledItemDelegate>

#include "core/station/alarms/alarm.h"

namespace leitstand {

/// Paints an alarm into a row: its sign, its robot's letter, what it says (in several lines where it is
/// long), for how long.
class AlarmDelegate final : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

/// The sign of a severity, told apart by its shape: a triangle to look, an octagon to act; filled while it
/// stands.
void paintAlarmSign(QPainter& painter, const QRectF& box, AlarmSeverity severity, bool filled,
                    const QColor& colour, const QColor& ink);

}  // namespace leitstand
