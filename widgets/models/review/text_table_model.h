#pragma once

#include "widgets/models/review/comparison_rows.h"
#include "widgets/models/text_rows_model.h"

namespace leitstand {

/// Texts in rows and columns. The hint of every cell is the meaning of its row.
class TextTableModel final : public TextRowsModel {
    Q_OBJECT
public:
    using TextRowsModel::TextRowsModel;

    void setTable(TextTable table);

protected:
    [[nodiscard]] int rowsInAll() const override { return static_cast<int>(m_table.rows.size()); }
    [[nodiscard]] QStringList headers() const override { return m_table.header; }
    [[nodiscard]] QString cell(int row, int column) const override;
    [[nodiscard]] QString hint(int row) const override;

private:
    TextTable m_table;
};

}  // namespace leitstand
