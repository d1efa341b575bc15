#pragma once

#include <vector>

#include "widgets/models/text_rows_model.h"
#include "widgets/models/victims/victim_rows.h"

namespace leitstand {

/// Victims, other finds and candidates as a table. The selection is kept while numbers change.
class VictimListModel final : public TextRowsModel {
    Q_OBJECT
public:
    enum Column { Name, State, Where, Found, Signs };

    /// Shows @p columns, from left to right.
    explicit VictimListModel(std::vector<Column> columns = {Name, State, Where, Signs},
                             QObject* parent = nullptr);

    void setRows(const std::vector<VictimRow>& rows);
    [[nodiscard]] const VictimRow* row(int row) const;  ///< null: there is none
    [[nodiscard]] const std::vector<VictimRow>& rows() const { return m_rows; }
    /// Returns the row of @p find; -1: it is not in the list.
    [[nodiscard]] int rowOf(const FindKey& find) const;
    /// Returns the index of @p column; -1: it is not shown.
    [[nodiscard]] int placeOf(Column column) const;

protected:
    [[nodiscard]] int rowsInAll() const override { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] QStringList headers() const override;
    [[nodiscard]] QString cell(int row, int column) const override;
    [[nodiscard]] QString hint(int row) const override;
    [[nodiscard]] Tone tone(int row, int column) const override;

private:
    std::vector<Column> m_columns;
    std::vector<VictimRow> m_rows;
};

}  // namespace leitstand
