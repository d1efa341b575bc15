#pragma once

#include <QAbstractTableModel>

#include "widgets/models/review/comparison_rows.h"

namespace leitstand {

/// Texts in rows and columns; every cell says what its row means.
class TextTableModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    using QAbstractTableModel::QAbstractTableModel;

    void setTable(TextTable table);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    TextTable m_table;
};

}  // namespace leitstand
