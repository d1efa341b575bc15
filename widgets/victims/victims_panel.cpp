#include "widgets/victims/victims_panel.h"

#include <QLabel>
#include <QTableView>
#include <QVBoxLayout>

#include "widgets/tables/button_flow.h"
#include "widgets/tables/column_fitter.h"
#include "widgets/tables/command_buttons.h"
#include "widgets/tables/table_dress.h"

namespace leitstand {

namespace {

using Column = VictimListModel::Column;

std::vector<Column> columnsFor(VictimsPanel::Use use) {
    const bool live = use == VictimsPanel::Use::Live;
    return {Column::Name, Column::State, live ? Column::Where : Column::Found, Column::Signs};
}

}  // namespace

VictimsPanel::VictimsPanel(QWidget* parent, Use use)
    : QWidget(parent),
      m_model(columnsFor(use)),
      m_title(new QLabel(this)),
      m_calm(new QLabel(this)),
      m_table(new QTableView(this)),
      m_buttons(new ButtonFlow) {
    setAccessibleName(tr("Victims and other finds"));
    m_title->setObjectName(QStringLiteral("victimsTitle"));
    const bool live = use == Use::Live;
    m_calm->setText(live ? tr("Nothing found yet. F files what the robot sees.")
                         : tr("Nothing was found yet"));
    m_calm->setProperty("muted", true);
    m_calm->setAlignment(Qt::AlignCenter);
    m_calm->setWordWrap(true);
    m_table->setObjectName(QStringLiteral("finds"));
    m_table->setAccessibleName(live ? tr("Victims, other finds and candidates")
                                    : tr("Finds; Return goes to the moment when the chosen one was found"));
    m_table->setModel(&m_model);
    dressTable(*m_table);
    m_table->setFrameShape(QFrame::NoFrame);
    const int state = m_model.placeOf(Column::State), signs = m_model.placeOf(Column::Signs);
    new ColumnFitter(*m_table, {signs, state}, signs);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &VictimsPanel::chosenChanged);
    connect(m_table, &QTableView::activated, this, &VictimsPanel::activated);
    m_buttons->setContentsMargins(8, 2, 8, 6);
    m_buttons->setSpacing(2);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(2);
    m_title->setContentsMargins(8, 4, 8, 0);
    rows->addWidget(m_title);
    rows->addWidget(m_table, 1);
    rows->addWidget(m_calm, 1);
    rows->addLayout(m_buttons);
    show({});
}

void VictimsPanel::show(const std::vector<VictimRow>& rows) {
    const auto kept = chosen();
    m_model.setRows(rows);
    if (kept && !chosen() && kept->filed()) (void)choose(kept->find);
    for (int row = 0; kept && !chosen() && !kept->filed() && row < m_model.rowCount(); ++row) {
        if (m_model.row(row)->candidate == kept->candidate) m_table->selectRow(row);
    }
    m_title->setText(victimsTitle(rows));
    m_table->setVisible(!rows.empty());
    m_calm->setVisible(rows.empty());
}

void VictimsPanel::addCommands(const std::vector<QAction*>& commands) {
    addCommandButtons(*m_buttons, commands, *this);
}

std::optional<VictimRow> VictimsPanel::chosen() const {
    const VictimRow* row = m_model.row(m_table->currentIndex().row());
    return row == nullptr ? std::nullopt : std::optional(*row);
}

bool VictimsPanel::choose(const FindKey& find) {
    const int row = m_model.rowOf(find);
    if (row >= 0) m_table->selectRow(row);
    return row >= 0;
}

}  // namespace leitstand
