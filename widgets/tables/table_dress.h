#pragma once

class QTableView;

namespace leitstand {

/// Sets what all tables of panes have in common. Whole rows are chosen, one at a time, without grid and row
/// headers. Tab goes to the next field; cells have the tone of their model. A ColumnFitter or the caller sets
/// the column widths. Rows are @p rowHeight tall [px] and do not wrap.
void dressTable(QTableView& table, int rowHeight = 24);

}  // namespace leitstand
