#include "app/window/panes/score/hand_in_feature.h"

#include <chrono>
#include <cmath>
#include <optional>

#include <QAction>
#include <QEvent>
#include <QFileDialog>
#include <QMainWindow>

#include "app/window/commands/command_table.h"
#include "app/window/frame/pane_docks.h"
#include "app/window/panes/finds/finds_feature.h"
#include "app/window/panes/score/folder_dialog.h"
#include "app/window/source/review_bridge.h"
#include "app/window/source/review_report.h"
#include "core/mission/state/mission_clock.h"
#include "widgets/score/score_pane.h"

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds Pause(300);  ///< between two estimates, while the mission is played

}  // namespace

HandInFeature::HandInFeature(const ReviewContext& context, FindsFeature& finds)
    : QObject(&context.window),
      m_context(context),
      m_bridge(context.review),
      m_finds(finds),
      m_score(new ScorePane(&context.window)) {
    m_score->setObjectName(QStringLiteral("scorePane"));
    m_write = &context.commands.add(
        {.id = QStringLiteral("review.report"),
         .menu = CommandMenu::Mission,
         .text = tr("R&eport into a folder…"),
         .hint = tr("Writes the judges' folder of this mission, with what was corrected in the review"),
         .keys = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_J)});
    m_score->setCommands({m_write});
    m_score->installEventFilter(this);
    m_soon.setSingleShot(true);
    m_soon.setInterval(Pause);
    connect(m_write, &QAction::triggered, this, &HandInFeature::askForFolder);
    connect(&context.review.report(), &ReviewReport::changed, this, &HandInFeature::showProgress);
    connect(&m_soon, &QTimer::timeout, this, &HandInFeature::showScore);
    // Emitted with each moment that is shown, and when something was corrected.
    connect(&finds, &FindsFeature::findsChanged, this, [this] {
        if (!m_soon.isActive()) m_soon.start();
    });
    showProgress();
}

QWidget& HandInFeature::pane() const {
    return *m_score;
}

bool HandInFeature::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_score && event->type() == QEvent::Show) m_soon.start();
    return QObject::eventFilter(watched, event);
}

void HandInFeature::askForFolder() {
    const QFileDialog& dialog = openFolderDialog(m_context.window, tr("Folder for the report"));
    connect(&dialog, &QFileDialog::fileSelected, this,
            [this](const QString& folder) { m_bridge.reportInto(folder); });
}

void HandInFeature::showProgress() {
    const ReviewReport& report = m_bridge.report();
    m_write->setEnabled(!report.writing());
    m_write->setIconText(
        report.writing() ? tr("Report: %1 %").arg(static_cast<int>(std::lround(100.0 * report.progress())))
                         : tr("Report"));
}

void HandInFeature::showScore() {
    if (!m_score->isVisible() || !m_bridge.reviewed()) return;
    const MissionState& mission = m_finds.state();
    const ScoreProfile* profile = m_board.profileOf(mission);
    if (profile == nullptr) return;
    const MissionClock clock = clockAt(mission.clock ? std::optional(mission.clock->sample) : std::nullopt,
                                       m_bridge.reviewed()->now);
    m_score->show(scoreText(*profile, score(*profile, mission, footprintsOf(m_bridge.robots())),
                            withLength(clock, profile->minutes)));
}

}  // namespace leitstand
