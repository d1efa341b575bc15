#include "widgets/tables/chosen_row.h"

#include <QTableView>

namespace leitstand {

void chooseRow(QTableView& table, int row) {
    if (row < 0) {
        table.clearSelection();
        table.setCurrentIndex({});
    } else if (row != table.currentIndex().row()) {
        table.selectRow(row);
    }
}

}  // namespace leitstand
