#include "widgets/changes/changes_panel.h"

#include <QFocusEvent>
#include <QLabel>
#include <QTableView>
#include <QVBoxLayout>

#include "widgets/tables/button_flow.h"
#include "widgets/tables/chosen_row.h"
#include "widgets/tables/column_fitter.h"
#include "widgets/tables/command_buttons.h"
#include "widgets/tables/table_dress.h"

namespace leitstand {

ChangesPanel::ChangesPanel(QWidget* parent)
    : QWidget(parent),
      m_title(new QLabel(this)),
      m_calm(new QLabel(this)),
      m_table(new QTableView(this)),
      m_buttons(new ButtonFlow) {
    setAccessibleName(tr("What changed"));
    setFocusPolicy(Qt::StrongFocus);
    m_title->setObjectName(QStringLiteral("changesTitle"));
    m_title->setWordWrap(true);
    m_title->setContentsMargins(8, 4, 8, 0);
    m_calm->setObjectName(QStringLiteral("changesCalm"));
    m_calm->setProperty("muted", true);
    m_calm->setAlignment(Qt::AlignCenter);
    m_calm->setWordWrap(true);
    m_table->setObjectName(QStringLiteral("changes"));
    m_table->setAccessibleName(tr("What came and what went, the largest first"));
    m_table->setModel(&m_model);
    dressTable(*m_table);
    m_table->setFrameShape(QFrame::NoFrame);
    new ColumnFitter(*m_table, {ChangedModel::Place, ChangedModel::Where}, ChangedModel::Where);
    connect(m_table, &QTableView::activated, this, &ChangesPanel::activated);
    m_buttons->setContentsMargins(8, 2, 8, 6);
    m_buttons->setSpacing(2);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(2);
    rows->addWidget(m_title);
    rows->addWidget(m_table, 1);
    rows->addWidget(m_calm, 1);
    rows->addLayout(m_buttons);
    show(nullptr, std::nullopt);
}

void ChangesPanel::focusInEvent(QFocusEvent* event) {
    if (m_table->isVisibleTo(this)) return m_table->setFocus(event->reason());
    QWidget::focusInEvent(event);
}

void ChangesPanel::show(const MapChanges* changes, const std::optional<Pose>& robotInMap) {
    constexpr double SamePlace = 0.5;  // things grow while they are looked at [m]
    const auto kept = chosen();
    const auto rows = changes != nullptr ? changedRows(*changes, robotInMap) : std::vector<ChangedRow>();
    m_model.setRows(rows);
    if (kept) chooseRow(*m_table, m_model.rowAt(kept->inMap, SamePlace));
    m_title->setText(changedText(changes));
    m_table->setVisible(!rows.empty());
    m_calm->setVisible(rows.empty());
    m_calm->setText(unchangedText(changes));
}

void ChangesPanel::setCommands(const std::vector<QAction*>& commands) {
    addCommandButtons(*m_buttons, commands, *this);
}

std::optional<ChangedRow> ChangesPanel::chosen() const {
    const ChangedRow* row = m_model.row(m_table->currentIndex().row());
    return row == nullptr ? std::nullopt : std::optional(*row);
}

}  // namespace leitstand
