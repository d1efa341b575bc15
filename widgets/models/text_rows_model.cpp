#include "widgets/models/text_rows_model.h"

namespace leitstand {

int TextRowsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : rowsInAll();
}

int TextRowsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(headers().size());
}

QVariant TextRowsModel::data(const QModelIndex& index, int role) const {
    const int row = index.row(), column = index.column();
    if (row < 0 || row >= rowsInAll() || column < 0 || column >= columnCount()) return {};
    if (role == ToneRole) return static_cast<int>(tone(row, column));
    if (role == Qt::DisplayRole) return cell(row, column);
    if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole) {
        const QString text = hint(row);
        return text.isEmpty() ? QVariant() : QVariant(text);
    }
    return {};
}

QVariant TextRowsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    return headers().value(section);
}

Tone TextRowsModel::tone(int /*row*/, int /*column*/) const {
    return Tone::Normal;
}

}  // namespace leitstand
