#pragma once

#include <vector>

#include <QObject>

class QTableView;

namespace leitstand {

/// Keeps a table free of clipped numbers: columns are as wide as their contents, and when the table is too
/// narrow for all of them some are hidden, in a stated order.
class ColumnFitter final : public QObject {
    Q_OBJECT
public:
    /// Fits @p table, which has a model, from now on; columns of @p givingWay go first to last, all others
    /// stay. The column @p stretched takes what width is left.
    ColumnFitter(QTableView& table, std::vector<int> givingWay, int stretched);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void change();
    void fit();

    QTableView& m_table;
    std::vector<int> m_givingWay;
    int m_stretched;
    bool m_changed = false;  ///< since it was fitted
};

}  // namespace leitstand
