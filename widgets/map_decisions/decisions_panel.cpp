#include "widgets/map_decisions/decisions_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/models/map/key_scan_model.h"
#include "widgets/painting/number_box.h"
#include "widgets/tables/column_fitter.h"
#include "widgets/tables/table_dress.h"

namespace leitstand {
namespace {

constexpr double UsualCeiling = 2.0;

/// Returns the schedules of pair distances for a retry, each from wide to narrow [m].
const std::vector<std::vector<double>>& schedules() {
    static const std::vector<std::vector<double>> all = {
        {1.5, 0.5, 0.25, 0.15}, {3.0, 1.5, 0.5, 0.25, 0.15}, {0.5, 0.25, 0.15}, {0.25, 0.15}};
    return all;
}

}  // namespace

DecisionsPanel::DecisionsPanel(KeyScanModel& scans, QWidget* parent)
    : QWidget(parent),
      m_scans(scans),
      m_title(new QLabel(this)),
      m_details(new QLabel(this)),
      m_areaText(new QLabel(this)),
      m_table(table()),
      m_retry(new QComboBox(this)),
      m_cut(new QCheckBox(tr("Nothing above"), this)),
      m_ceiling(new NumberBox(-10, 50, 0.1, 1, tr("m"), this)),
      m_decisions(new QGridLayout),
      m_area(new QGridLayout) {
    setAccessibleName(tr("Scans and decisions"));
    m_title->setProperty("title", true);
    m_details->setWordWrap(true);
    m_details->setProperty("muted", true);
    m_details->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_details->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_details->setMinimumHeight(3 * fontMetrics().height());
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(6, 0, 6, 6);
    rows->setSpacing(4);
    rows->addWidget(m_title);
    rows->addWidget(m_table, 1);
    rows->addWidget(m_details);
    rows->addLayout(m_decisions);
    rows->addWidget(retryLine());
    rows->addWidget(worldLine());
    for (QGridLayout* grid : {m_decisions, m_area}) grid->setSpacing(4);
    const auto show = [this] { showChosen(); };
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, show);
    connect(&scans, &QAbstractItemModel::dataChanged, this, show);
    connect(&scans, &QAbstractItemModel::rowsInserted, this, show);
    connect(&scans, &QAbstractItemModel::modelReset, this, show);
    showChosen();
}

QTableView* DecisionsPanel::table() {
    auto* view = new QTableView(this);
    view->setObjectName(QStringLiteral("keyScans"));
    view->setAccessibleName(tr("Key scans of the map, newest first"));
    view->setModel(&m_scans);
    dressTable(*view);
    using Column = KeyScanModel::Column;
    new ColumnFitter(*view, {Column::Entered, Column::Overlap}, Column::Doubts);
    return view;
}

QWidget* DecisionsPanel::retryLine() {
    auto* line = new QWidget(this);
    auto* label = new QLabel(tr("Retry with"), line);
    label->setProperty("muted", true);
    label->setBuddy(m_retry);
    m_retry->setObjectName(QStringLiteral("retrySchedule"));
    m_retry->setAccessibleName(tr("How far a retry searches"));
    m_retry->setToolTip(
        tr("How far points may be from the map at first: wide finds a scan that is far off, "
           "narrow does not mistake one wall for another"));
    m_retry->addItems({tr("wide search, 1.5 m"), tr("widest search, 3 m"), tr("usual search, 0.5 m"),
                       tr("narrow search, 0.25 m")});
    auto* row = new QHBoxLayout(line);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(label);
    row->addWidget(m_retry, 1);
    return line;
}

QWidget* DecisionsPanel::worldLine() {
    auto* group = new QWidget(this);
    m_cut->setObjectName(QStringLiteral("cutCeiling"));
    m_cut->setToolTip(
        tr("Points above this height, in the map's frame, are left out of the map: spectators, lamps, the "
           "hall's roof"));
    m_ceiling->setObjectName(QStringLiteral("ceiling"));
    m_ceiling->setAccessibleName(tr("Height above which nothing enters the map"));
    m_ceiling->setToolTip(m_cut->toolTip());
    m_ceiling->setValue(UsualCeiling);
    m_ceiling->setEnabled(false);
    m_areaText->setProperty("muted", true);
    m_areaText->setWordWrap(true);
    auto* rows = new QVBoxLayout(group);
    rows->setContentsMargins(0, 4, 0, 0);
    rows->setSpacing(4);
    auto* line = new QHBoxLayout;
    line->addWidget(m_cut);
    line->addWidget(m_ceiling);
    line->addStretch(1);
    rows->addLayout(line);
    rows->addLayout(m_area);
    rows->addWidget(m_areaText);
    connect(m_cut, &QCheckBox::toggled, this, &DecisionsPanel::publishCeiling);
    connect(m_ceiling, &QDoubleSpinBox::editingFinished, this, &DecisionsPanel::publishCeiling);
    return group;
}

// A field that is destroyed with the focus emits editingFinished, when this is no longer a DecisionsPanel.
DecisionsPanel::~DecisionsPanel() {
    m_ceiling->disconnect(this);
}

void DecisionsPanel::addButtons(QGridLayout& grid, const std::vector<QAction*>& commands) {
    int place = 0;
    for (QAction* command : commands) {
        const int at = place++;
        if (command == nullptr) continue;
        auto* button = new QToolButton(this);
        button->setDefaultAction(command);
        button->setObjectName(QStringLiteral("button_") + command->objectName());
        button->setAccessibleName(command->iconText());
        const QString name = command->iconText();
        const auto label = [button, command, name] {
            const QString keys = command->shortcut().toString(QKeySequence::NativeText);
            button->setText(keys.isEmpty() ? name : name + QStringLiteral("  ") + keys);
        };
        connect(command, &QAction::changed, button,
                label);  // after the button's own slot, which takes iconText
        label();
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        button->setFocusPolicy(Qt::StrongFocus);
        grid.addWidget(button, at / 2, at % 2);
    }
}

void DecisionsPanel::setDecisions(const std::vector<QAction*>& commands) {
    addButtons(*m_decisions, commands);
}

void DecisionsPanel::setAreaCommands(const std::vector<QAction*>& commands) {
    addButtons(*m_area, commands);
}

std::uint64_t DecisionsPanel::chosen() const {
    const LiveKeyScan* const scan = m_scans.scanAt(m_table->currentIndex().row());
    return scan == nullptr ? 0 : scan->id;
}

void DecisionsPanel::choose(std::uint64_t id) {
    const int row = m_scans.rowOf(id);
    if (row >= 0) m_table->selectRow(row);
}

std::vector<double> DecisionsPanel::retrySchedule() const {
    return schedules()[static_cast<std::size_t>(std::max(0, m_retry->currentIndex()))];
}

void DecisionsPanel::setCeiling(const std::optional<double>& height) {
    const QSignalBlocker quiet(m_cut), quietHeight(m_ceiling);
    m_cut->setChecked(height.has_value());
    m_ceiling->setEnabled(height.has_value());
    if (height) m_ceiling->setValue(*height);
}

void DecisionsPanel::setAreaText(const QString& text) {
    m_areaText->setText(text);
}

void DecisionsPanel::publishCeiling() {
    m_ceiling->setEnabled(m_cut->isChecked());
    emit ceilingWanted(m_cut->isChecked() ? std::optional(m_ceiling->value()) : std::nullopt);
}

void DecisionsPanel::showChosen() {
    m_title->setText(keyScanSummary(m_scans));
    const LiveKeyScan* const scan = m_scans.scanAt(m_table->currentIndex().row());
    m_details->setText(scan == nullptr ? tr("Choose a scan, or go to the newest doubtful one")
                                       : keyScanDetails(*scan));
    const std::uint64_t now = chosen();
    if (now == m_reported) return;
    m_reported = now;
    emit chosenChanged(now);
}

}  // namespace leitstand
