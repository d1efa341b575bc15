#include "widgets/scans/registration_panel.h"

#include <QAction>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/painting/number_box.h"
#include "widgets/tables/fields.h"

namespace leitstand {
namespace {

constexpr int MostIterations = 10'000, MostThreads = 256;

void mark(QLineEdit& edit, bool wrong) {
    if (edit.property("wrong").toBool() == wrong) return;
    edit.setProperty("wrong", wrong);
    edit.style()->unpolish(&edit);
    edit.style()->polish(&edit);
}

QToolButton* actionButton(QAction& action, const QString& name, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setObjectName(name);
    button->setDefaultAction(&action);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    return button;
}

}  // namespace

RegistrationPanel::RegistrationPanel(QAction& again, QAction& before, QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("registration"));
    auto* fields = new QWidget(this);
    auto* form = new QFormLayout(fields);
    form->setContentsMargins(10, 2, 10, 6);
    form->setHorizontalSpacing(12);
    form->setVerticalSpacing(4);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    addMethods(*form);
    addPoints(*form);
    addStart(*form);

    auto* scroll = new QScrollArea(this);
    scroll->setWidget(fields);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(scroll, 1);
    layout->addWidget(buttons(again, before));

    for (auto* box : findChildren<QComboBox*>()) {
        keepFromWheel(*box);
        connect(box, &QComboBox::currentIndexChanged, this, &RegistrationPanel::takeOver);
    }
    for (auto* box : findChildren<NumberBox*>()) {
        keepFromWheel(*box);
        connect(box, &QDoubleSpinBox::valueChanged, this, &RegistrationPanel::takeOver);
    }
    connect(m_distances, &QLineEdit::textChanged, this, &RegistrationPanel::takeOver);
    setSettings({});
}

void RegistrationPanel::addMethods(QFormLayout& form) {
    m_minimizer = choiceBox(minimizerChoices(), this);
    m_minimizer->setObjectName(QStringLiteral("minimizer"));
    addField(form, tr("M&inimise"), m_minimizer);
    m_search = choiceBox(searchChoices(), this);
    m_search->setObjectName(QStringLiteral("search"));
    addField(form, tr("&Nearest points"), m_search);
    m_epsilon = new NumberBox(0.0, 10.0, 0.1, 2, {}, this);
    m_epsilon->setObjectName(QStringLiteral("epsilon"));
    addField(form, tr("A&pproximation ε"), m_epsilon,
             tr("The point found is at most (1 + ε) times as far as the nearest one (Arya & Mount 1993); 0: "
                "exact. "
                "Applies to the approximate tree and the forest."));
    m_distances = new QLineEdit(this);
    m_distances->setObjectName(QStringLiteral("distances"));
    addField(form, tr("Maximum &distance"), withUnit(m_distances, tr("m")),
             tr("Pairs of points farther apart are dropped. Several values are stages, one after another: "
                "\"1.5, 0.5\" "
                "comes home from starts that are up to 1 m and 20° wrong."));
    m_distancesWrong = new QLabel(tr("0.01 to 10 m, each at most the one before: 1.5, 0.5"), this);
    m_distancesWrong->setProperty("attention", true);
    m_distancesWrong->setWordWrap(true);
    form.addRow(m_distancesWrong);
    m_iterations = new NumberBox(1, MostIterations, 10, 0, {}, this);
    m_iterations->setObjectName(QStringLiteral("iterations"));
    addField(form, tr("Steps at m&ost"), m_iterations,
             tr("Iterations of the ICP for a scan, over all stages."));
}

void RegistrationPanel::addPoints(QFormLayout& form) {
    m_reduce = new NumberBox(0.0, 1.0, 0.05, 2, tr("m"), this);
    m_reduce->setObjectName(QStringLiteral("reduce"));
    m_reduce->setSpecialValueText(tr("all points"));
    addField(form, tr("Voxe&ls"), m_reduce,
             tr("Edge of the voxel grid: one point is kept in each voxel. 0 uses all points. A grid of 10 cm "
                "moves "
                "the result by some centimetres and takes a fraction of the time."));
    m_filter = choiceBox(filterChoices(), this);
    m_filter->setObjectName(QStringLiteral("filter"));
    addField(form, tr("Fil&ter"), m_filter);

    m_minRange = new NumberBox(0.0, 10.0, 0.1, 2, {}, this);
    m_minRange->setObjectName(QStringLiteral("minRange"));
    m_maxRange = new NumberBox(0.5, 300.0, 1.0, 1, tr("m"), this);
    m_maxRange->setObjectName(QStringLiteral("maxRange"));
    auto* range = new QWidget(this);
    auto* line = new QHBoxLayout(range);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(m_minRange, 1);
    line->addWidget(new QLabel(tr("to"), range));
    line->addWidget(m_maxRange, 1);
    range->setFocusProxy(m_minRange);
    addField(form, tr("Ran&ge"), range,
             tr("Points nearer than the first (the robot itself) and farther than the second (no echo) take "
                "no part."));
}

void RegistrationPanel::addStart(QFormLayout& form) {
    m_guess = choiceBox(guessChoices(), this);
    m_guess->setObjectName(QStringLiteral("guess"));
    addField(form, tr("&Start from"), m_guess);
    m_reference = choiceBox(referenceChoices(), this);
    m_reference->setObjectName(QStringLiteral("reference"));
    addField(form, tr("Match &against"), m_reference);
    m_threads = new NumberBox(0, MostThreads, 1, 0, {}, this);
    m_threads->setObjectName(QStringLiteral("threads"));
    m_threads->setSpecialValueText(tr("all cores"));
    addField(form, tr("Thr&eads"), m_threads, tr("How many processor cores may work at once."));
}

QWidget* RegistrationPanel::buttons(QAction& again, QAction& before) {
    auto* row = new QWidget(this);
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(10, 6, 10, 10);
    line->setSpacing(6);
    line->addWidget(actionButton(again, QStringLiteral("registerAgain"), row), 3);
    line->addWidget(actionButton(before, QStringLiteral("before"), row), 2);
    auto* defaults = new QPushButton(tr("Defa&ults"), row);
    defaults->setObjectName(QStringLiteral("defaults"));
    defaults->setToolTip(tr("Puts every setting back to where it was at first."));
    connect(defaults, &QPushButton::clicked, this, [this] {
        setSettings({});
        emit settingsChanged(m_settings);
    });
    line->addWidget(defaults);
    return row;
}

void RegistrationPanel::setSettings(const RegistrationSettings& settings) {
    const QScopedValueRollback showing(m_showing, true);
    m_settings = settings;
    choose(*m_minimizer, settings.minimizer);
    choose(*m_search, settings.search);
    m_epsilon->setValue(settings.epsilon);
    m_distances->setText(scheduleText(settings.maxDistances));
    m_iterations->setValue(settings.maxIterations);
    m_reduce->setValue(settings.reduce);
    choose(*m_filter, settings.filter);
    m_minRange->setValue(settings.minRange);
    m_maxRange->setValue(settings.maxRange);
    choose(*m_guess, settings.guess);
    choose(*m_reference, settings.reference);
    m_threads->setValue(settings.threads);
    showWhatApplies();
}

void RegistrationPanel::takeOver() {
    if (m_showing) return;
    m_settings.minimizer = chosen<Minimizer>(*m_minimizer);
    m_settings.search = chosen<SearchMethod>(*m_search);
    m_settings.epsilon = m_epsilon->value();
    if (const auto distances = parseSchedule(m_distances->text())) m_settings.maxDistances = *distances;
    m_settings.maxIterations = static_cast<int>(m_iterations->value());
    m_settings.reduce = m_reduce->value();
    m_settings.filter = chosen<ScanFilter>(*m_filter);
    m_settings.minRange = m_minRange->value();
    m_settings.maxRange = m_maxRange->value();
    m_settings.guess = chosen<GuessSource>(*m_guess);
    m_settings.reference = chosen<Reference>(*m_reference);
    m_settings.threads = static_cast<int>(m_threads->value());
    showWhatApplies();
    emit settingsChanged(m_settings);
}

void RegistrationPanel::showWhatApplies() {
    const bool wrong = !parseSchedule(m_distances->text());
    mark(*m_distances, wrong);
    m_distancesWrong->setVisible(wrong);
    m_epsilon->setEnabled(m_settings.search == SearchMethod::Approximate ||
                          m_settings.search == SearchMethod::Forest);
    m_maxRange->setMinimum(m_settings.minRange + 0.1);
}

}  // namespace leitstand
