#include "app/window/panes/alarms/alarms_feature.h"

#include <algorithm>
#include <chrono>
#include <vector>

#include <QAction>
#include <QMainWindow>
#include <QTimer>

#include "app/services/station/safety/station_alarms.h"
#include "app/services/station/station.h"
#include "app/window/commands/command_table.h"
#include "app/window/input/selection.h"
#include "app/window/source/moment_source.h"
#include "widgets/alarms/alarm_panel.h"
#include "widgets/models/live/texts/alarm_text.h"

namespace leitstand {
namespace {

constexpr std::chrono::seconds Muted(60);
constexpr std::chrono::milliseconds BetweenTones(1'500);
constexpr int TicksShown = 3;  ///< ticks between updates of the list: 10 Hz

}  // namespace

AlarmsFeature::AlarmsFeature(const LiveContext& context)
    : QObject(&context.window), m_context(context), m_panel(new AlarmPanel(&context.window)) {
    addCommands();
    StationAlarms& alarms = context.station.alarms();
    connect(m_panel, &AlarmPanel::acknowledged, this,
            [&alarms](const AlarmId& id) { alarms.acknowledge(id); });
    connect(m_panel, &AlarmPanel::newestAcknowledged, this, [&alarms] { alarms.acknowledgeNewest(); });
    connect(m_panel, &AlarmPanel::muteToggled, this, &AlarmsFeature::toggleMute);
    const auto notifyTrouble = [this] {
        m_panel->setSoundTrouble(m_player.trouble());
        emit soundTroubleChanged(m_player.trouble());
    };
    connect(&m_player, &TonePlayer::troubleChanged, this, notifyTrouble);
    notifyTrouble();
    m_second.setSingleShot(true);
    m_second.setInterval(BetweenTones);
    connect(&m_second, &QTimer::timeout, this, [this] { m_player.play(AlarmTone::Act); });
    connect(&context.source, &MomentSource::ticked, this, &AlarmsFeature::show);
}

QWidget& AlarmsFeature::pane() const {
    return *m_panel;
}

void AlarmsFeature::addCommands() {
    StationAlarms& alarms = m_context.station.alarms();
    m_acknowledge =
        &m_context.commands.add({.id = "alarm.acknowledge",
                                 .menu = CommandMenu::Mission,
                                 .text = tr("&Acknowledge the newest alarm"),
                                 .hint = tr("Its tone ends; it stays in the list while it stands"),
                                 .keys = QKeySequence(Qt::Key_Backspace)});
    m_acknowledge->setEnabled(false);
    connect(m_acknowledge, &QAction::triggered, this, [&alarms] { alarms.acknowledgeNewest(); });
    QAction& mute = m_context.commands.add({.id = "alarm.mute",
                                            .menu = CommandMenu::Mission,
                                            .text = tr("&Mute alarms for a minute"),
                                            .hint = tr("No tones; again: tones at once"),
                                            .keys = QKeySequence(Qt::Key_M)});
    connect(&mute, &QAction::triggered, this, &AlarmsFeature::toggleMute);
}

void AlarmsFeature::toggleMute() {
    StationAlarms& alarms = m_context.station.alarms();
    const bool muted = alarms.view().mutedUntil > m_context.source.moment().now;
    alarms.mute(muted ? std::chrono::seconds(0) : Muted);
}

void AlarmsFeature::tryTones() {
    m_player.play(AlarmTone::Attention);
    m_second.start();
}

void AlarmsFeature::show(const LiveMoment& moment) {
    if (++m_sinceShown < TicksShown) return;
    m_sinceShown = 0;
    const AlarmsView view = m_context.station.alarms().view();
    const std::vector<RobotFace> faces = m_context.selection.faces();
    const std::vector<AlarmLine> lines = alarmLinesOf(view.alarms, faces, moment.now);
    m_acknowledge->setEnabled(
        std::any_of(lines.begin(), lines.end(), [](const AlarmLine& line) { return !line.acknowledged; }));
    m_panel->show(lines, muteText(view.mutedUntil, moment.now), muteBrief(view.mutedUntil, moment.now));
    if (const auto tone = m_voice.due(view.loud, view.attentions, view.mutedUntil, moment.now)) {
        m_second.stop();
        m_player.play(*tone);
        emit sounded(*tone);
    }
}

}  // namespace leitstand
