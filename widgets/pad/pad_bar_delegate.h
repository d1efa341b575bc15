#pragma once

#include <QStyledItemDelegate>

namespace leitstand {

/// Draws below a control how far it is pushed (PadTable::AmountRole), as a bar.
class PadBarDelegate final : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
};

}  // namespace leitstand
