#include "widgets/tables/column_fitter.h"

#include <algorithm>
#include <utility>

#include <QEvent>
#include <QHeaderView>
#include <QTableView>

namespace leitstand {

ColumnFitter::ColumnFitter(QTableView& table, std::vector<int> givingWay, int stretched)
    : QObject(&table), m_table(table), m_givingWay(std::move(givingWay)), m_stretched(stretched) {
    table.viewport()->installEventFilter(this);
    // Only visible rows are measured: a list of a thousand scans is measured again with each new scan.
    constexpr int RowsInSight = 0;
    table.horizontalHeader()->setResizeContentsPrecision(RowsInSight);
    const QAbstractItemModel* model = table.model();
    connect(model, &QAbstractItemModel::dataChanged, this, &ColumnFitter::change);
    connect(model, &QAbstractItemModel::rowsInserted, this, &ColumnFitter::change);
    connect(model, &QAbstractItemModel::rowsRemoved, this, &ColumnFitter::change);
    connect(model, &QAbstractItemModel::modelReset, this, &ColumnFitter::change);
    fit();
}

bool ColumnFitter::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize || (event->type() == QEvent::Show && m_changed)) fit();
    return QObject::eventFilter(watched, event);
}

/// A hidden table is fitted when it is shown: it would treat all rows as visible.
void ColumnFitter::change() {
    m_changed = true;
    if (m_table.isVisible()) fit();
}

void ColumnFitter::fit() {
    m_changed = false;
    QHeaderView* header = m_table.horizontalHeader();
    std::vector<int> widths;
    int needed = 0;
    for (int column = 0; column < header->count(); ++column) {
        m_table.setColumnHidden(column, false);
        m_table.resizeColumnToContents(column);
        widths.push_back(m_table.columnWidth(column));
        needed += widths.back();
    }
    const int available = m_table.viewport()->width();
    for (const int column : m_givingWay) {
        if (needed <= available) break;
        m_table.setColumnHidden(column, true);
        needed -= widths[static_cast<std::size_t>(column)];
    }
    // If the stretched column is hidden itself, the last visible one is stretched.
    int stretched = m_stretched;
    for (int column = 0; m_table.isColumnHidden(m_stretched) && column < header->count(); ++column) {
        if (!m_table.isColumnHidden(column)) stretched = column;
    }
    m_table.setColumnWidth(stretched,
                           widths[static_cast<std::size_t>(stretched)] + std::max(0, available - needed));
}

}  // namespace leitstand
