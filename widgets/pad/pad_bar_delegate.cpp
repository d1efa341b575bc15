#include "widgets/pad/pad_bar_delegate.h"

#include <QPainter>

#include "widgets/models/pad/pad_table.h"
#include "widgets/painting/theme.h"

namespace leitstand {

void PadBarDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const {
    QStyledItemDelegate::paint(painter, option, index);
    const double amount = index.data(PadTable::AmountRole).toDouble();
    if (amount <= 0.0) return;
    const QRect& box = option.rect;
    painter->fillRect(QRectF(box.left(), box.bottom() - 3, amount * box.width(), 3),
                      coloursOf(presentTheme()).select);
}

}  // namespace leitstand
