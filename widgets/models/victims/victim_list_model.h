#pragma once

#include <vector>

#include <QAbstractTableModel>

#include "widgets/models/victims/victim_rows.h"

namespace leitstand {

/// Victims, other finds and candidates as a table. A choice is kept while numbers change.
class VictimListModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Name, State, Where, Signs, ColumnCount };

    using QAbstractTableModel::QAbstractTableModel;

    void setRows(const std::vector<VictimRow>& rows);
    [[nodiscard]] const VictimRow* row(int row) const;  ///< null when there is none
    [[nodiscard]] const std::vector<VictimRow>& rows() const { return m_rows; }
    /// The row of @p find; -1: it is not there.
    [[nodiscard]] int rowOf(const FindKey& find) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::vector<VictimRow> m_rows;
};

}  // namespace leitstand
