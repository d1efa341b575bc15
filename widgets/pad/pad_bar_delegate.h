#pragma once

#include <QStyledItemDelegate>

namespace leitstand {

/// Draws a bar below a control that shows how far it is pushed (PadTable::AmountRole).
class PadBarDelegate final : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
};

}  // namespace leitstand
