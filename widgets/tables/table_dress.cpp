#include "widgets/tables/table_dress.h"

#include <QHeaderView>
#include <QTableView>

#include "widgets/tables/tone_delegate.h"

namespace leitstand {

void dressTable(QTableView& table, int rowHeight) {
    constexpr int NarrowestColumn = 24;  // [px]
    table.setItemDelegate(new ToneDelegate(&table));
    table.setSelectionBehavior(QAbstractItemView::SelectRows);
    table.setSelectionMode(QAbstractItemView::SingleSelection);
    table.setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    table.setShowGrid(false);
    table.setWordWrap(false);
    table.setTabKeyNavigation(false);
    table.verticalHeader()->hide();
    table.verticalHeader()->setDefaultSectionSize(rowHeight);
    table.horizontalHeader()->setHighlightSections(false);
    table.horizontalHeader()->setMinimumSectionSize(NarrowestColumn);
    table.horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
}

}  // namespace leitstand
