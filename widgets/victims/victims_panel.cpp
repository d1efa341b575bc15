#include "widgets/victims/victims_panel.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/tables/column_fitter.h"
#include "widgets/tables/table_dress.h"

namespace leitstand {

VictimsPanel::VictimsPanel(QWidget* parent)
    : QWidget(parent),
      m_title(new QLabel(this)),
      m_calm(new QLabel(tr("Nothing found yet. F files what the robot sees."), this)),
      m_table(new QTableView(this)),
      m_buttons(new QHBoxLayout) {
    setAccessibleName(tr("Victims and other finds"));
    m_title->setObjectName(QStringLiteral("victimsTitle"));
    m_calm->setProperty("muted", true);
    m_calm->setAlignment(Qt::AlignCenter);
    m_calm->setWordWrap(true);
    m_table->setObjectName(QStringLiteral("finds"));
    m_table->setAccessibleName(tr("Victims, other finds and candidates"));
    m_table->setModel(&m_model);
    dressTable(*m_table);
    m_table->setFrameShape(QFrame::NoFrame);
    new ColumnFitter(*m_table, {VictimListModel::Signs, VictimListModel::State}, VictimListModel::Signs);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &VictimsPanel::chosenChanged);
    connect(m_table, &QTableView::activated, this, &VictimsPanel::activated);
    m_buttons->setContentsMargins(8, 2, 8, 6);
    m_buttons->setSpacing(6);
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

void VictimsPanel::setCommands(const std::vector<QAction*>& commands) {
    for (QAction* command : commands) {
        auto* button = new QToolButton(this);
        button->setDefaultAction(command);
        button->setText(command->iconText());
        button->setProperty("quiet", true);
        button->setFocusPolicy(Qt::TabFocus);
        m_buttons->addWidget(button);
    }
    m_buttons->addStretch(1);
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
