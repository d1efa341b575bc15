#pragma once

#include <vector>

#include <QObject>

class QTableView;

namespace leitstand {

/// Prevents numbers in a table from being cut. Columns are as wide as their contents; if the table is too
/// narrow, some columns are hidden in a given order.
class ColumnFitter final : public QObject {
    Q_OBJECT
public:
    /// Fits @p table, which must have a model. The columns @p givingWay are hidden, in this order, if there
    /// is not enough space; all others are always shown. The column @p stretched takes the remaining width.
    ColumnFitter(QTableView& table, std::vector<int> givingWay, int stretched);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void change();
    void fit();

    QTableView& m_table;
    std::vector<int> m_givingWay;
    int m_stretched;
    bool m_changed = false;  ///< whether contents changed since the columns were last fitted
};

}  // namespace leitstand
