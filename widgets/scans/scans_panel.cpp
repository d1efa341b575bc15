#include "widgets/scans/scans_panel.h"

#include <QAction>
#include <QTableView>
#include <QVBoxLayout>

#include "widgets/models/scan_list_model.h"
#include "widgets/scans/scan_details_view.h"
#include "widgets/tables/column_fitter.h"
#include "widgets/tables/table_dress.h"

namespace leitstand {
namespace {

constexpr int RowHeight = 26;  ///< [px], of a tick box

}  // namespace

ScansPanel::ScansPanel(ScanListModel& scans, QWidget* parent)
    : QWidget(parent), m_scans(scans), m_table(new QTableView(this)), m_details(new ScanDetailsView(this)) {
    m_table->setObjectName(QStringLiteral("scans"));
    m_table->setAccessibleName(tr("Scans of the map"));
    m_table->setModel(&scans);
    dressTable(*m_table, RowHeight);
    using Column = ScanListModel::Column;
    new ColumnFitter(*m_table,
                     {Column::Ceiling, Column::Wall, Column::Floor, Column::Heading, Column::Points,
                      Column::Position, Column::Iterations},
                     Column::Certainty);

    auto* showAll = new QAction(tr("Show all scans"), m_table);
    connect(showAll, &QAction::triggered, &scans, [&scans] { scans.setAllVisible(true); });
    auto* hideAll = new QAction(tr("Hide all scans"), m_table);
    connect(hideAll, &QAction::triggered, &scans, [&scans] { scans.setAllVisible(false); });
    m_table->addActions({showAll, hideAll});
    m_table->setContextMenuPolicy(Qt::ActionsContextMenu);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_details);

    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            &ScansPanel::showCurrent);
    connect(&scans, &QAbstractItemModel::dataChanged, this, &ScansPanel::showCurrent);
    connect(&scans, &QAbstractItemModel::rowsRemoved, this, &ScansPanel::showCurrent);
    connect(&scans, &QAbstractItemModel::rowsInserted, this,
            [this](const QModelIndex&, int, int last) { m_table->selectRow(last); });
    showCurrent();
}

void ScansPanel::showCurrent() {
    const int row = m_table->currentIndex().row();
    const auto& list = m_scans.map()->scans;
    const bool known = row >= 0 && row < static_cast<int>(list.size());
    m_details->setScan(known ? &list[static_cast<std::size_t>(row)] : nullptr);
}

}  // namespace leitstand
