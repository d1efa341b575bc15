#include "widgets/link/stream_list.h"

#include <QItemSelectionModel>

#include "widgets/tables/column_fitter.h"
#include "widgets/tables/table_dress.h"

namespace leitstand {

StreamList::StreamList(StreamTable::Of of, QWidget* parent) : QTableView(parent), m_streams(of) {
    setObjectName(QStringLiteral("streams"));
    setAccessibleName(tr("Streams of all robots"));
    setModel(&m_streams);
    dressTable(*this);
    using Column = StreamTable::Column;
    if (of == StreamTable::Of::Link)
        new ColumnFitter(*this, {Column::Type, Column::Loss, Column::Age, Column::Load}, Column::Setting);
    else
        new ColumnFitter(*this, {Column::Type}, Column::Name);
    connect(selectionModel(), &QItemSelectionModel::currentRowChanged, this, &StreamList::chosenChanged);
    connect(&m_streams, &QAbstractItemModel::modelReset, this, &StreamList::chosenChanged);
}

}  // namespace leitstand
