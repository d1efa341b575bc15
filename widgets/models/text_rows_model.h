#pragma once

#include <algorithm>
#include <vector>

#include <QAbstractTableModel>
#include <QStringList>

#include "widgets/models/tone.h"

namespace leitstand {

/// Read-only rows: texts in columns with headers. Each row has one hint for all of its cells.
class TextRowsModel : public QAbstractTableModel {
    Q_OBJECT
public:
    using QAbstractTableModel::QAbstractTableModel;

    int rowCount(const QModelIndex& parent = {}) const final;
    int columnCount(const QModelIndex& parent = {}) const final;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const final;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const final;

protected:
    [[nodiscard]] virtual int rowsInAll() const = 0;
    [[nodiscard]] virtual QStringList headers() const = 0;
    [[nodiscard]] virtual QString cell(int row, int column) const = 0;  ///< row and column must exist
    [[nodiscard]] virtual QString hint(int row) const = 0;  ///< also the accessible text; may be empty
    [[nodiscard]] virtual Tone tone(int row, int column) const;

    /// Replaces @p mine by @p rows. If both have the same length and @p same is true for each pair, only the
    /// texts change and the selection is kept. Otherwise the model is reset.
    template <class Row, class Same>
    void replace(std::vector<Row>& mine, const std::vector<Row>& rows, Same same) {
        if (rows == mine) return;
        if (std::equal(rows.begin(), rows.end(), mine.begin(), mine.end(), same)) {
            mine = rows;
            emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
            return;
        }
        beginResetModel();
        mine = rows;
        endResetModel();
    }
};

}  // namespace leitstand
