#include "app/window/live/mission/mission_feature.h"

#include <chrono>

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QInputDialog>
#include <QMainWindow>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSpinBox>
#include <QTimer>
#include <QVBoxLayout>

#include "app/services/recorded/carried_map.h"
#include "app/services/score/score_board.h"
#include "app/services/station/station.h"
#include "app/services/station/station_clock.h"
#include "app/window/commands/command_table.h"
#include "app/window/source/moment_source.h"
#include "widgets/mission/clock_face.h"
#include "widgets/mission/record_light.h"
#include "widgets/models/live/texts/clock_text.h"
#include "widgets/models/live/texts/record_text.h"

namespace leitstand {
namespace {

constexpr int TicksALog = 15;          ///< ticks between two looks at the log: twice a second
constexpr double Megabyte = 1e6;       ///< [B]
constexpr int LongestMission = 1'440;  ///< [min]
constexpr std::chrono::minutes Offered(30);

}  // namespace

MissionFeature::MissionFeature(const LiveContext& context, const QString& folder)
    : QObject(&context.window),
      m_context(context),
      m_folder(folder),
      m_bar(new QWidget(&context.window)),
      m_light(new RecordLight(m_bar)),
      m_face(new ClockFace(m_bar)) {
    auto* lines = new QVBoxLayout(m_bar);
    lines->setContentsMargins(0, 0, 0, 0);
    lines->setSpacing(0);
    lines->addWidget(m_light);
    lines->addWidget(m_face);
    addCommands();
    connect(m_face, &ClockFace::clicked, this, [this] {
        auto* menu = new QMenu(m_face);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        menu->addActions({m_run, m_length, m_reset});
        menu->popup(m_face->mapToGlobal(QPoint(0, m_face->height())));
    });
    connect(&context.source, &MomentSource::ticked, this, &MissionFeature::show);
}

void MissionFeature::addCommands() {
    CommandTable& commands = m_context.commands;
    StationClock& clock = m_context.station.clock();
    const auto show = [this](const Result<void>& done) {
        if (!done) m_context.notify(QString::fromStdString(done.error().text));
    };
    m_run = &commands.add({.id = "mission.clock",
                           .menu = CommandMenu::Mission,
                           .text = tr("&Clock runs"),
                           .hint = tr("Lets the mission's clock go, or holds it"),
                           .checkable = true});
    connect(m_run, &QAction::triggered, this, [&clock, show](bool on) { show(clock.run(on)); });
    m_length = &commands.add({.id = "mission.length",
                              .menu = CommandMenu::Mission,
                              .text = tr("&Length of the mission…"),
                              .hint = tr("How long the mission may last: the clock counts down from it")});
    connect(m_length, &QAction::triggered, this, &MissionFeature::askForLength);
    m_reset = &commands.add({.id = "mission.clockReset",
                             .menu = CommandMenu::Mission,
                             .text = tr("Clock to &zero"),
                             .hint = tr("The mission begins now")});
    connect(m_reset, &QAction::triggered, this, [&clock, show] { show(clock.reset()); });
    m_earlier =
        &commands.add({.id = "mission.earlier",
                       .menu = CommandMenu::Mission,
                       .text = tr("&Go on with the mission before"),
                       .hint = tr("Ends this mission, and goes on with the one that was recorded until "
                                  "shortly before it: map, finds, clock")});
    m_earlier->setEnabled(false);
    connect(m_earlier, &QAction::triggered, this, &MissionFeature::askForEarlier);
    m_inMap =
        &commands.add({.id = "mission.inMap",
                       .menu = CommandMenu::Mission,
                       .text = tr("A &new mission in the map of…"),
                       .hint = tr("Ends this mission, and begins a new one that goes on in its map, or in "
                                  "that of an earlier one; robots find their place in it as they drive")});
    connect(m_inMap, &QAction::triggered, this, &MissionFeature::askForMap);
}

void MissionFeature::offerEarlier(const QString& name) {
    m_earlierName = name;
    m_earlier->setEnabled(true);
    QTimer::singleShot(Offered, this, [this] { m_earlier->setEnabled(false); });
}

void MissionFeature::askForEarlier() {
    askToEnd(QStringLiteral("goOnWithEarlier"), tr("The mission before"),
             tr("End this mission and go on with %1?").arg(m_earlierName), tr("Go on with it"),
             [this] { emit earlierWanted(); });
}

void MissionFeature::askForMap() {
    auto* choice = new QFileDialog(&m_context.window, tr("A new mission in the map of…"), m_folder);
    choice->setObjectName(QStringLiteral("mapOf"));
    choice->setAttribute(Qt::WA_DeleteOnClose);
    choice->setModal(false);
    choice->setFileMode(QFileDialog::Directory);
    choice->setOption(QFileDialog::ShowDirsOnly);
    connect(choice, &QFileDialog::fileSelected, this, [this](const QString& folder) {
        if (const auto there = hasMap(folder.toStdString()); !there) {
            m_context.notify(QString::fromStdString(there.error().text));
            return;
        }
        askToEnd(QStringLiteral("newInMap"), tr("A new mission"),
                 tr("End this mission and begin a new one in the map of %1?").arg(QDir(folder).dirName()),
                 tr("Begin it"), [this, folder] { emit mapWanted(folder); });
    });
    choice->show();
}

void MissionFeature::askToEnd(const QString& name, const QString& title, const QString& text,
                              const QString& yes, const std::function<void()>& ends) {
    auto* question = new QMessageBox(&m_context.window);  // not modal: robots may be driving
    question->setObjectName(name);
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->setModal(false);
    question->setIcon(QMessageBox::Question);
    question->setWindowTitle(title);
    question->setText(text);
    question->setInformativeText(tr("Robots stop for some seconds. This mission is kept."));
    question->addButton(tr("Stay"), QMessageBox::RejectRole);
    QPushButton* const goOn = question->addButton(yes, QMessageBox::AcceptRole);
    goOn->setObjectName(QStringLiteral("goOn"));
    connect(goOn, &QPushButton::clicked, this, ends);
    question->show();
}

void MissionFeature::askForLength() {
    StationClock& clock = m_context.station.clock();
    auto* question = new QInputDialog(&m_context.window);  // not modal: robots may be driving
    question->setObjectName(QStringLiteral("missionLength"));
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->setWindowTitle(tr("Length of the mission"));
    question->setLabelText(tr("Minutes; 0: without end"));
    question->setInputMode(QInputDialog::IntInput);
    question->setIntRange(0, LongestMission);
    // The length by the rules of the mission's year is offered first.
    const ScoreBoard board;
    const ScoreProfile* const rules = board.profileOf(*m_context.source.moment().mission);
    const MissionClock offered = withLength(clock.now(), rules == nullptr ? 0.0 : rules->minutes);
    question->setIntValue(
        static_cast<int>(std::chrono::duration_cast<std::chrono::minutes>(offered.limit).count()));
    if (auto* const minutes = question->findChild<QSpinBox*>())
        minutes->setAccessibleName(question->labelText());
    connect(question, &QInputDialog::intValueSelected, this, [this, &clock](int minutes) {
        if (const auto set = clock.limit(std::chrono::minutes(minutes)); !set)
            m_context.notify(QString::fromStdString(set.error().text));
    });
    question->show();
}

void MissionFeature::show(const LiveMoment& /*moment*/) {
    const MissionClock clock = m_context.station.clock().now();
    m_face->show(clockText(clock));
    m_run->setChecked(clock.running);
    if (m_sinceLog++ % TicksALog != 0) return;
    const LiveMissionStatus log = m_context.station.log();
    m_light->show(recordText({.folder = m_folder,
                              .megabytes = static_cast<double>(log.bytes) / Megabyte,
                              .minutesLeft = log.minutesLeft,
                              .lost = log.lost,
                              .problem = QString::fromStdString(log.problem)}));
}

}  // namespace leitstand
