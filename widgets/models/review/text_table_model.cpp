#include "widgets/models/review/text_table_model.h"

#include <utility>

namespace leitstand {

void TextTableModel::setTable(TextTable table) {
    beginResetModel();
    m_table = std::move(table);
    endResetModel();
}

QString TextTableModel::cell(int row, int column) const {
    return m_table.rows[static_cast<std::size_t>(row)].cells.value(column);
}

QString TextTableModel::hint(int row) const {
    return m_table.rows[static_cast<std::size_t>(row)].hint;
}

}  // namespace leitstand
