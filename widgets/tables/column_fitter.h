#pragma once

#include <vector>

#include <QObject>

class QTableView;

namespace leitstand {

/// Keeps a table free of clipped numbers. Columns are as wide as their contents; if the table is too narrow,
/// some are hidden in a given order.
class ColumnFitter final : public QObject {
    Q_OBJECT
public:
    /// Fits @p table, which must have a model. Columns of @p givingWay are hidden in that order when there is
    /// too little room; all others stay. The column @p stretched takes the remaining width.
    ColumnFitter(QTableView& table, std::vector<int> givingWay, int stretched);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void change();
    void fit();

    QTableView& m_table;
    std::vector<int> m_givingWay;
    int m_stretched;
    bool m_changed = false;  ///< contents changed since the last fit
};

}  // namespace leitstand
