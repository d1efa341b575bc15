#pragma once

#include <QStyledItemDelegate>

namespace leitstand {

/// Draws items in the colour of their ToneRole (muted, plain or attention), with some padding.
class ToneDelegate final : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

}  // namespace leitstand
