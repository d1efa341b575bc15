#pragma once

class QTableView;

namespace leitstand {

/// What all tables of panes have in common: whole rows are chosen, one at a time; neither grid nor row
/// headers; Tab goes on to the next field; cells in the tone of their model. Columns have fixed widths, which
/// a ColumnFitter or the caller sets; rows are @p rowHeight tall [px] and their texts do not wrap.
void dressTable(QTableView& table, int rowHeight = 24);

}  // namespace leitstand
