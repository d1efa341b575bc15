#include "app/window/panes/score/report_feature.h"

#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QMainWindow>

#include "app/report/pdf/pdf_report.h"
#include "app/services/handin/writing/report_folder.h"
#include "app/services/handin/writing/report_keeper.h"
#include "app/services/handin/writing/report_messages.h"
#include "app/services/station/station.h"
#include "app/services/station/station_clock.h"
#include "app/window/commands/command_table.h"
#include "app/window/frame/pane_docks.h"
#include "app/window/panes/score/folder_dialog.h"
#include "app/window/source/moment_source.h"
#include "widgets/mission/mission_form.h"
#include "widgets/score/score_pane.h"

namespace leitstand {
namespace {

constexpr int TicksAScore = 30;  ///< ticks between estimates of the score: once a second

}  // namespace

ReportFeature::ReportFeature(const LiveContext& context)
    : QObject(&context.window), m_context(context), m_score(new ScorePane(&context.window)) {
    m_score->setObjectName(QStringLiteral("scorePane"));
    addCommands();
    // Receivers are connected once all features are made.
    for (const std::string& problem : m_board.problems()) {
        QMetaObject::invokeMethod(
            this, [this, problem] { m_context.notify(QString::fromStdString(problem)); },
            Qt::QueuedConnection);
    }
    connect(&context.source, &MomentSource::ticked, this, &ReportFeature::show);
    goOn();
}

ReportFeature::~ReportFeature() = default;

QWidget& ReportFeature::pane() const {
    return *m_score;
}

/// Continues the report of the window before, after a window was created again or a station resumed its
/// mission. Not at once: the map has to be there again first.
void ReportFeature::goOn() {
    const auto folder = QString::fromStdString(reportFolderOf(m_context.station.folder()).string());
    if (folder.isEmpty()) return;
    beginKeeping(folder);
    QMetaObject::invokeMethod(
        this, [this, folder] { m_context.notify(tr("The report goes on into %1").arg(folder)); },
        Qt::QueuedConnection);
}

void ReportFeature::addCommands() {
    CommandTable& commands = m_context.commands;
    commands.separate(CommandMenu::Mission);
    connect(
        &commands.add({.id = QStringLiteral("mission.data"),
                       .menu = CommandMenu::Mission,
                       .text = tr("Mission d&ata…"),
                       .hint = tr("Competition, team, operators, rules of the score: what the report says")}),
        &QAction::triggered, this, &ReportFeature::askForData);
    m_keep = &commands.add({.id = QStringLiteral("mission.report"),
                            .menu = CommandMenu::Mission,
                            .text = tr("&Report into a folder…"),
                            .hint = tr("Writes the judges' folder now, and again every minute"),
                            .keys = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_J),
                            .checkable = true});
    connect(m_keep, &QAction::triggered, this, [this](bool on) {
        if (on) return askForFolder();
        stop();
    });
    m_keep->setIconText(tr("Report"));
    m_score->setCommands({m_keep});
}

void ReportFeature::stop() {
    endKeeping();
    remember({});
    m_context.notify(tr("The report is not written any more"));
}

void ReportFeature::remember(const QString& folder) {
    const auto kept = keepReportFolder(m_context.station.folder(), folder.toStdString());
    if (!kept) m_context.notify(QString::fromStdString(kept.error().text));
}

void ReportFeature::setInterval(std::chrono::nanoseconds interval) {
    m_interval = interval;
    if (m_keeper) beginKeeping(QString(m_folder));
}

void ReportFeature::endKeeping() {
    if (!m_keeper) return;
    m_keeper->end();  // the driver does not wait for a file
    m_ended.push_back(std::move(m_keeper));
}

void ReportFeature::askForData() {
    MissionForm::Profiles profiles;
    for (const ScoreProfile& profile : m_board.profiles())
        profiles.emplace_back(QString::fromStdString(profile.name), QString::fromStdString(profile.title));
    const auto& known = m_context.source.moment().mission->info;
    auto* form = new MissionForm(known ? known->sample : MissionInfoSample(), profiles, &m_context.window);
    form->setAttribute(Qt::WA_DeleteOnClose);
    connect(form, &MissionForm::wanted, this, [this](const MissionInfoSample& info) {
        if (const auto reported = m_context.station.describe(info); !reported)
            m_context.notify(QString::fromStdString(reported.error().text));
    });
    form->show();
}

void ReportFeature::askForFolder() {
    m_keep->setChecked(false);
    const QFileDialog& dialog = openFolderDialog(m_context.window, tr("Folder for the report"));
    connect(&dialog, &QFileDialog::fileSelected, this, &ReportFeature::keep);
}

void ReportFeature::keep(const QString& folder) {
    beginKeeping(folder);
    m_keeper->writeNow();
    remember(folder);
}

void ReportFeature::beginKeeping(const QString& folder) {
    ReportKeeper::Settings settings;
    settings.mission = m_context.station.folder();
    settings.out = folder.toStdString();
    settings.options.pdf = &pdfOf;
    settings.options.version = QApplication::applicationVersion().toStdString();
    settings.interval = m_interval;
    endKeeping();
    m_folder = folder;
    m_keeper = std::make_unique<ReportKeeper>(
        settings, [this, out = settings.out, publishing = ReportMessages()](const auto& done) mutable {
            const std::vector<std::string> words = publishing.of(done, out);
            QMetaObject::invokeMethod(
                this,
                [this, words] {
                    for (const std::string& text : words) m_context.notify(QString::fromStdString(text));
                },
                Qt::QueuedConnection);
        });
    m_keep->setChecked(true);
}

void ReportFeature::show(const LiveMoment& moment) {
    if (!m_score->isVisible()) {
        m_sinceScore = 0;  // the score shows at once when the pane opens
        return;
    }
    if (m_sinceScore++ % TicksAScore != 0) return;
    const ScoreProfile* profile = m_board.profileOf(*moment.mission);
    if (profile == nullptr) return;
    // When nobody set a length, the one of the rules counts.
    const MissionClock clock = withLength(m_context.station.clock().now(), profile->minutes);
    m_score->show(scoreText(
        *profile, score(*profile, *moment.mission, footprintsOf(m_context.source.robots())), clock));
}

}  // namespace leitstand
