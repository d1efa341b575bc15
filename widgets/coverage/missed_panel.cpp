#include "widgets/coverage/missed_panel.h"

#include <QComboBox>
#include <QFocusEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QTableView>
#include <QVBoxLayout>

#include "widgets/models/coverage/sensor_text.h"
#include "widgets/tables/button_flow.h"
#include "widgets/tables/chosen_row.h"
#include "widgets/tables/column_fitter.h"
#include "widgets/tables/command_buttons.h"
#include "widgets/tables/table_dress.h"

namespace leitstand {

MissedPanel::MissedPanel(QWidget* parent)
    : QWidget(parent),
      m_sensor(new QComboBox(this)),
      m_title(new QLabel(this)),
      m_calm(new QLabel(this)),
      m_table(new QTableView(this)),
      m_buttons(new ButtonFlow) {
    setAccessibleName(tr("What was missed"));
    for (const SearchSensor sensor : SearchSensors)
        m_sensor->addItem(sensorText(sensor), static_cast<int>(sensor));
    m_sensor->setObjectName(QStringLiteral("missedSensor"));
    m_sensor->setAccessibleName(tr("Searched with"));
    m_sensor->setToolTip(tr("With which sensor the floor counts as searched"));
    m_title->setObjectName(QStringLiteral("missedTitle"));
    m_title->setWordWrap(true);
    m_calm->setProperty("muted", true);
    m_calm->setAlignment(Qt::AlignCenter);
    m_calm->setWordWrap(true);
    m_table->setObjectName(QStringLiteral("missed"));
    m_table->setAccessibleName(tr("Floor that was missed, the largest piece first"));
    m_table->setModel(&m_model);
    dressTable(*m_table);
    m_table->setFrameShape(QFrame::NoFrame);
    new ColumnFitter(*m_table, {MissedModel::Place, MissedModel::Where}, MissedModel::Where);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &MissedPanel::chosenChanged);
    connect(m_table, &QTableView::activated, this, &MissedPanel::activated);
    connect(m_sensor, &QComboBox::activated, this, [this] { emit sensorChosen(sensor()); });
    auto* head = new QHBoxLayout;
    head->setContentsMargins(8, 4, 8, 0);
    head->addWidget(m_title, 1);
    head->addWidget(m_sensor);
    m_buttons->setContentsMargins(8, 2, 8, 6);
    m_buttons->setSpacing(2);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(2);
    rows->addLayout(head);
    rows->addWidget(m_table, 1);
    rows->addWidget(m_calm, 1);
    rows->addLayout(m_buttons);
    setSensor(SearchSensor::Camera);
    show(nullptr, std::nullopt);
}

void MissedPanel::focusInEvent(QFocusEvent* event) {
    // No focus proxy: while it is hidden, Tab could not leave the widget before this one.
    QWidget& taken = m_table->isVisibleTo(this) ? static_cast<QWidget&>(*m_table) : *m_sensor;
    taken.setFocus(event->reason());
}

void MissedPanel::show(const SearchedFloorPtr& searched, const std::optional<Pose>& robotInMap) {
    constexpr double SamePlace = 0.75;  // pieces shrink while they are looked at [m]
    const auto kept = chosen();
    const auto rows = searched ? missedRows(*searched, sensor(), robotInMap) : std::vector<MissedRow>();
    m_model.setRows(rows);
    if (kept) {
        chooseRow(*m_table, m_model.rowAt(kept->inMap, SamePlace));
        emit chosenChanged();  // a table that was reset does not notify
    }
    m_title->setText(searched ? searchedText(*searched, sensor()) : QString());
    m_table->setVisible(!rows.empty());
    m_calm->setVisible(rows.empty());
    m_calm->setText(emptyText(searched.get(), sensor()));
}

SearchSensor MissedPanel::sensor() const {
    return static_cast<SearchSensor>(m_sensor->currentData().toInt());
}

void MissedPanel::setSensor(SearchSensor sensor) {
    m_sensor->setCurrentIndex(m_sensor->findData(static_cast<int>(sensor)));
}

void MissedPanel::setCommands(const std::vector<QAction*>& commands) {
    addCommandButtons(*m_buttons, commands, *this);
}

std::optional<MissedRow> MissedPanel::chosen() const {
    const MissedRow* row = m_model.row(m_table->currentIndex().row());
    return row == nullptr ? std::nullopt : std::optional(*row);
}

void MissedPanel::chooseFirst() {
    if (!chosen() && m_model.rowCount() > 0) m_table->selectRow(0);
}

}  // namespace leitstand
