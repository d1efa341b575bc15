#pragma once

#include <QStyledItemDelegate>

namespace leitstand {

/// Draws items in the colour of their ToneRole: muted, plain or attention.
class ToneDelegate final : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

}  // namespace leitstand
