#pragma once

class QTableView;

namespace leitstand {

/// Chooses @p row of @p table after a model reset; below 0: none.
void chooseRow(QTableView& table, int row);

}  // namespace leitstand
