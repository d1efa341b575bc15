#pragma once

class QTableView;

namespace leitstand {

/// Selects @p row of @p table, which is needed after a model reset. Negative: clears the selection.
void chooseRow(QTableView& table, int row);

}  // namespace leitstand
