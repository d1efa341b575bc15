#include "widgets/review/compare_panel.h"

#include <QButtonGroup>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QRadioButton>
#include <QTabWidget>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/painting/number_box.h"
#include "widgets/tables/fields.h"
#include "widgets/tables/table_dress.h"

namespace leitstand {

ComparePanel::ComparePanel(QWidget* parent)
    : QWidget(parent),
      m_schedule(RegistrationSettings().maxDistances),
      m_begin(new QToolButton(this)),
      m_progress(new QProgressBar(this)),
      m_maps(new QButtonGroup(this)),
      m_note(new QLabel(
          tr("Registers the mission's key scans once more, with these settings, and puts both maps "
             "beside each other: how well scans meet, how far they moved, how long it took. "
             "Nothing of the mission is changed. The newest result is kept with it."),
          this)) {
    setAccessibleName(tr("Registered again and compared"));
    auto* fields = new QWidget(this);
    auto* form = new QFormLayout(fields);
    form->setContentsMargins(8, 4, 8, 0);
    form->setVerticalSpacing(4);
    addSettings(*form);
    m_begin->setObjectName(QStringLiteral("beginComparison"));
    connect(m_begin, &QToolButton::clicked, this, [this] {
        if (m_comparing) return emit cancelled();
        emit wanted(settings());
    });
    m_progress->setObjectName(QStringLiteral("comparisonProgress"));
    m_progress->setAccessibleName(tr("How far the comparison is"));
    m_progress->setRange(0, 100);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(8, 0, 8, 0);
    row->addWidget(m_begin);
    row->addWidget(m_progress, 1);
    row->addStretch(0);
    m_note->setObjectName(QStringLiteral("comparisonNote"));
    m_note->setProperty("muted", true);
    m_note->setWordWrap(true);
    m_note->setAlignment(Qt::AlignTop);
    m_note->setMargin(8);
    m_choice = mapChoice();
    m_tables = tables();
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 4);
    rows->setSpacing(4);
    rows->addWidget(fields);
    rows->addLayout(row);
    rows->addWidget(m_choice);
    rows->addWidget(m_tables, 1);
    rows->addWidget(m_note, 1);
    m_choice->setVisible(false);
    m_tables->setVisible(false);
    setComparing(false);
}

void ComparePanel::addSettings(QFormLayout& form) {
    m_minimizer = choiceBox(minimizerChoices(), this);
    m_minimizer->setObjectName(QStringLiteral("compareMinimizer"));
    ::leitstand::choose(*m_minimizer, RegistrationSettings().minimizer);
    addField(form, tr("M&inimise"), m_minimizer);
    m_reference = choiceBox(referenceChoices(), this);
    m_reference->setObjectName(QStringLiteral("compareReference"));
    ::leitstand::choose(*m_reference, RegistrationSettings().reference);
    addField(form, tr("A&gainst"), m_reference);
    m_distances = new QLineEdit(scheduleText(m_schedule), this);
    m_distances->setObjectName(QStringLiteral("compareDistances"));
    addField(form, tr("Maximum &distance"), withUnit(m_distances, tr("m")),
             tr("Pairs of points farther apart are dropped; 0.01 to 10 m. Several values are stages, each at "
                "most the one before: 1.5, 0.5"));
    m_reduce = new NumberBox(0.0, 1.0, 0.05, 2, tr("m"), this);
    m_reduce->setObjectName(QStringLiteral("compareReduce"));
    m_reduce->setSpecialValueText(tr("all points"));
    m_reduce->setValue(RegistrationSettings().reduce);
    addField(form, tr("Voxe&ls"), m_reduce, tr("Edge of the grid to which scans are thinned"));
    for (QWidget* field : {static_cast<QWidget*>(m_minimizer), static_cast<QWidget*>(m_reference),
                           static_cast<QWidget*>(m_reduce)})
        keepFromWheel(*field);
    connect(m_distances, &QLineEdit::textChanged, this, [this](const QString& text) {
        const auto read = parseSchedule(text);
        if (read) m_schedule = *read;
        m_begin->setEnabled(m_comparing || read.has_value());
    });
}

QWidget* ComparePanel::mapChoice() {
    auto* whole = new QWidget(this);
    auto* row = new QHBoxLayout(whole);
    row->setContentsMargins(8, 0, 8, 0);
    const auto add = [&](ComparedMap which, const char* name, const QString& text, const QString& hint) {
        auto* button = new QRadioButton(text, whole);
        button->setObjectName(QLatin1String(name));
        button->setToolTip(hint);
        m_maps->addButton(button, static_cast<int>(which));
        row->addWidget(button);
    };
    add(ComparedMap::Recorded, "mapRecorded", tr("Recorded"), tr("The map pane shows the mission's own map"));
    add(ComparedMap::Again, "mapAgain", tr("Again"), tr("It shows the map registered again"));
    add(ComparedMap::Both, "mapBoth", tr("Both"),
        tr("It shows both: the recorded one in grey, the one registered again in its colours"));
    row->addStretch(1);
    m_maps->button(static_cast<int>(ComparedMap::Recorded))->setChecked(true);
    connect(m_maps, &QButtonGroup::idClicked, this,
            [this](int id) { emit mapChosen(static_cast<ComparedMap>(id)); });
    return whole;
}

QWidget* ComparePanel::tables() {
    auto* tabs = new QTabWidget(this);
    tabs->setDocumentMode(true);
    const auto add = [&](TextTableModel& model, const char* name, const QString& title) {
        auto* table = new QTableView(tabs);
        table->setObjectName(QLatin1String(name));
        table->setAccessibleName(title);
        table->setModel(&model);
        dressTable(*table);
        table->setFrameShape(QFrame::NoFrame);
        table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
        table->horizontalHeader()->setStretchLastSection(true);
        tabs->addTab(table, title);
    };
    add(m_figures, "comparisonFigures", tr("Figures"));
    add(m_scans, "comparisonScans", tr("Key scans"));
    return tabs;
}

RegistrationSettings ComparePanel::settings() const {
    RegistrationSettings settings;
    settings.minimizer = chosen<Minimizer>(*m_minimizer);
    settings.reference = chosen<Reference>(*m_reference);
    settings.reduce = m_reduce->value();
    settings.maxDistances = m_schedule;
    return settings;
}

void ComparePanel::setSettings(const RegistrationSettings& settings) {
    ::leitstand::choose(*m_minimizer, settings.minimizer);
    ::leitstand::choose(*m_reference, settings.reference);
    m_distances->setText(scheduleText(settings.maxDistances));
    m_reduce->setValue(settings.reduce);
}

void ComparePanel::setComparing(bool on) {
    m_comparing = on;
    m_begin->setText(on ? tr("Cancel") : tr("Register again"));
    m_begin->setToolTip(on ? tr("What was compared before stays")
                           : tr("Registers the mission's key scans with these settings and compares; the "
                                "mission stays as it is"));
    m_begin->setAccessibleName(m_begin->text());
    m_begin->setEnabled(on || parseSchedule(m_distances->text()).has_value());
    m_progress->setVisible(on);
    m_progress->setValue(0);
}

void ComparePanel::showProgress(double fraction) {
    if (m_comparing) m_progress->setValue(static_cast<int>(100.0 * fraction));
}

void ComparePanel::showResult(const MapComparison& comparison) {
    m_figures.setTable(figuresOf(comparison));
    m_scans.setTable(scansOf(comparison));
    m_note->setVisible(false);
    m_choice->setVisible(true);
    m_tables->setVisible(true);
}

void ComparePanel::choose(ComparedMap which) {
    m_maps->button(static_cast<int>(which))->setChecked(true);
}

}  // namespace leitstand
