#include "app/window/live/preflight/preflight_feature.h"

#include <utility>
#include <vector>

#include <QAction>
#include <QDialog>
#include <QFileDialog>
#include <QLabel>
#include <QMainWindow>
#include <QTimer>
#include <QVBoxLayout>

#include "app/services/station/choose_robots.h"
#include "app/services/station/safety/station_brakes.h"
#include "app/services/station/station.h"
#include "app/window/commands/command_table.h"
#include "app/window/frame/corner_badge.h"
#include "app/window/frame/over_panes.h"
#include "app/window/input/selection.h"
#include "app/window/source/moment_source.h"
#include "widgets/models/others_text.h"
#include "widgets/preflight/preflight_page.h"

namespace leitstand {
namespace {

constexpr std::chrono::seconds Rhythm(1), FirstLook(8);  ///< robots are found within some seconds

}  // namespace

PreflightFeature::PreflightFeature(const LiveContext& context)
    : QObject(&context.window),
      m_context(context),
      m_desk(context.station),
      m_dialog(new QDialog(&context.window)),
      m_page(new PreflightPage(m_dialog)),
      m_badge(makeCornerBadge(context.window, QStringLiteral("brakeBadge"))) {
    QAction& opens = context.commands.add({.id = QStringLiteral("preflight.open"),
                                           .menu = CommandMenu::Mission,
                                           .text = tr("&Preflight..."),
                                           .hint = tr("What is in order before the mission and what is not; "
                                                      "brake tests; adding robots"),
                                           .keys = QKeySequence(Qt::Key_F9)});
    connect(&opens, &QAction::triggered, this, &PreflightFeature::open);
    m_dialog->setWindowTitle(tr("Preflight"));
    auto* layout = new QVBoxLayout(m_dialog);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_page);
    m_dialog->resize(900, 640);
    buildPage();
    connect(&context.source, &MomentSource::ticked, this, &PreflightFeature::show);
}

void PreflightFeature::buildPage() {
    StationBrakes& brakes = m_context.station.brakes();
    connect(m_page, &PreflightPage::checkAgainWanted, this, [this] {
        m_desk.measure();
        refresh();
    });
    connect(m_page, &PreflightPage::brakeBegun, this,
            [&brakes](const QString& robot) { brakes.begin(robot.toStdString()); });
    connect(m_page, &PreflightPage::brakeHeld, this,
            [&brakes](const QString& robot) { brakes.hold(robot.toStdString()); });
    connect(m_page, &PreflightPage::brakeEnded, this,
            [&brakes](const QString& robot) { brakes.end(robot.toStdString()); });
    connect(m_page, &PreflightPage::overrideWanted, this, [this, &brakes](const QString& robot, bool on) {
        brakes.setOverridden(robot.toStdString(), on);
        showOverrides();
        refresh();
    });
    connect(m_page, &PreflightPage::strangerWanted, this, &PreflightFeature::add);
    connect(m_page, &PreflightPage::tonesWanted, this, &PreflightFeature::tonesWanted);
    connect(m_page, &PreflightPage::fileWanted, this, &PreflightFeature::addFile);
}

void PreflightFeature::setGamepad(const QString& name) {
    m_gamepad = name;
}

void PreflightFeature::setSoundTrouble(const QString& why) {
    m_soundTrouble = why;
}

PreflightFacts PreflightFeature::facts() const {
    PreflightFacts facts = m_desk.facts(m_gamepad.toStdString());
    facts.soundProblem = m_soundTrouble.toStdString();
    return facts;
}

void PreflightFeature::openWhenSomethingFails() {
    QTimer::singleShot(FirstLook, this, [this] {
        for (const RobotDescription& robot : m_context.selection.robots()) {
            if (m_context.source.moment().view(robot.name).drive.focus) return;
        }
        if (worstOf(preflight(facts())) == CheckState::Fail) open();
    });
}

void PreflightFeature::open() {
    refresh();
    showOverPanes(*m_dialog, m_context.panes);
}

void PreflightFeature::refresh() {
    const PreflightFacts found = facts();
    const std::vector<RobotFace> faces = m_context.selection.faces();
    QStringList strangers;
    for (const std::string& stranger : found.strangers) strangers += QString::fromStdString(stranger);
    m_page->show(preflight(found), faces, strangers);
}

void PreflightFeature::show(const LiveMoment& moment) {
    const bool due = moment.steady - m_shown >= Rhythm;
    if (due) {
        m_shown = moment.steady;
        showOverrides();
    }
    if (!m_dialog->isVisible()) return;
    if (due) refresh();
    const StationBrakes& brakes = m_context.station.brakes();
    const std::string robot = m_page->brakeRobot().toStdString();
    m_page->showBrake(brakeText(brakes.phase(robot), brakes.result(robot)), brakes.refuses(robot),
                      brakes.isOverridden(robot));
}

void PreflightFeature::showOverrides() {
    const StationBrakes& brakes = m_context.station.brakes();
    QStringList none, late, noneNames, lateNames;
    for (const RobotDescription& robot : m_context.selection.robots()) {
        if (!brakes.isOverridden(robot.name)) continue;
        const bool noWatchdog = brakes.result(robot.name).showsNoWatchdog();
        (noWatchdog ? none : late) += othersText(robot.letter);
        (noWatchdog ? noneNames : lateNames) += othersText(robot.title);
    }
    QStringList texts, tips;
    const auto addWarning = [&](const QString& text, const QStringList& names, const QString& tip) {
        if (names.isEmpty()) return;
        texts += text;
        tips += names.join(QStringLiteral(", ")) + QStringLiteral(": ") + tip;
    };
    addWarning(tr("NO WATCHDOG: %1").arg(none.join(QLatin1Char(' '))), noneNames,
               tr("Failed its brake test and is driven nevertheless: without radio it goes on. When this "
                  "station hangs or dies, its guard stops it"));
    addWarning(tr("BRAKES LATE: %1").arg(late.join(QLatin1Char(' '))), lateNames,
               tr("Failed its brake test and is driven nevertheless: without radio it stands late"));
    m_badge->setText(texts.join(QStringLiteral("  ")));
    m_badge->setToolTip(tips.join(QLatin1Char('\n')));
    m_badge->setVisible(!texts.isEmpty());
}

void PreflightFeature::add(const QString& stranger) {
    for (const RobotGuess& guess : m_desk.strangers()) {
        if (QString::fromStdString(guess.robot.name) != stranger) continue;
        const auto file = writeFirstFile(guess.robot, m_context.station.robots());
        if (!file) return m_page->complain(QString::fromStdString(file.error().text));
        return join(QString::fromStdString(*file));
    }
    m_page->complain(tr("%1 is not heard any more").arg(stranger));
}

void PreflightFeature::addFile() {
    // Not modal and not the desktop's own: STOP, by Esc and by its button, works while it is open.
    auto* dialog = new QFileDialog(m_dialog, tr("Robot file"), {}, tr("Robot files (*.yaml *.yml)"));
    dialog->setOption(QFileDialog::DontUseNativeDialog);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setModal(false);
    connect(dialog, &QFileDialog::fileSelected, this, &PreflightFeature::join);
    dialog->show();
}

void PreflightFeature::join(const QString& file) {
    const auto joins = checkJoins(file.toStdString(), m_context.station.robots());
    if (!joins) return m_page->complain(QString::fromStdString(joins.error().text));
    emit robotWanted(file);
}

}  // namespace leitstand
