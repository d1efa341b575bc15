#pragma once

class QTableView;

namespace leitstand {

/// Sets what all tables of panes have in common: no grid, no row headers, and rows that are @p rowHeight high
/// [px] and do not wrap. One whole row can be selected at a time. Tab goes to the next field. A ToneDelegate
/// colours the cells. A ColumnFitter or the caller sets the column widths.
void dressTable(QTableView& table, int rowHeight = 24);

}  // namespace leitstand
