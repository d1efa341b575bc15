#include "app/window/live/live_window.h"

#include <utility>

#include <QApplication>
#include <QCloseEvent>

#include "app/window/commands/command_table.h"
#include "app/window/commands/help_commands.h"
#include "app/window/commands/language_commands.h"
#include "app/window/frame/key_columns.h"
#include "app/window/frame/pane_docks.h"
#include "app/window/frame/window_frame.h"
#include "app/window/input/selection.h"
#include "app/window/layouts/layout_feature.h"
#include "app/window/layouts/layout_switch.h"
#include "app/window/live/closing_question.h"
#include "app/window/live/mission/mission_feature.h"
#include "app/window/live/pad/pad_feature.h"
#include "app/window/live/preflight/preflight_feature.h"
#include "app/window/panes/alarms/alarms_feature.h"
#include "app/window/panes/camera/camera_feature.h"
#include "app/window/panes/drive/drive_feature.h"
#include "app/window/panes/joints/joints_feature.h"
#include "app/window/panes/link/link_feature.h"
#include "app/window/panes/map/map_feature.h"
#include "app/window/panes/view_context.h"
#include "app/window/robots/measures_feature.h"
#include "app/window/robots/robots_feature.h"
#include "app/window/source/live_bridge.h"
#include "core/mission/state/session_state.h"
#include "widgets/models/others_text.h"
#include "widgets/painting/plain_texts.h"
#include "widgets/painting/theme.h"

namespace leitstand {
namespace {

// How a gamepad rumbles along with the tones of alarms.
constexpr double WeakRumble = 0.3, StrongRumble = 0.9;
constexpr int ShortRumble = 200, LongRumble = 600;  ///< [ms]

}  // namespace

LiveWindow::LiveWindow(LiveBridge& bridge, const MapViewSettings& view, LayoutBook layouts, PadMemory pads,
                       QWidget* parent)
    : QMainWindow(parent), m_bridge(bridge) {
    keepTextsPlain();
    applyTheme(*qApp, view.theme);  // before widgets exist, which would have to be styled again
    setWindowTitle(tr("Leitstand"));
    setWindowIcon(QIcon(QStringLiteral(":/leitstand/icons/leitstand.svg")));
    m_selection = new Selection(bridge.station().robots(), this);
    m_commands = new CommandTable(*this);
    m_panes = new PaneDocks(this);
    const LiveContext context{{m_bridge, *m_selection, *m_commands, *m_panes, *this, &bridge.station()},
                              bridge.station()};
    // Each feature adds its commands. The layouts come last: they place the panes and bind the keys.
    m_mission = new MissionFeature(context, QString::fromStdString(bridge.station().folder()));
    m_robots = new RobotsFeature(context);
    m_features = makePanes(context, view);
    m_pads = new PadFeature(context, m_features.drive->input(), std::move(pads));
    m_preflight = new PreflightFeature(context);
    m_measures = new MeasuresFeature(context);
    m_closing = new ClosingQuestion(context);
    addLanguageCommands(*m_commands, [this](const QString& code) { emit languageWanted(code); });
    m_layouts = new LayoutFeature(context, std::move(layouts), *m_features.map);
    (new HelpCommands(*this, KeyColumns::live()))->fill(m_commands->menu(CommandMenu::Help));
    m_commands->adopt(CommandMenu::Help);
    build();
    connectFeatures();
    m_bridge.showAgain();
    m_layouts->use(QStringLiteral("drive"));
}

LiveWindow::~LiveWindow() {
    setDriving(false);
    // Signals that features emit during destruction reach nobody.
    m_bridge.disconnect(this);
    for (QObject* part : children()) part->disconnect(this);
}

void LiveWindow::build() {
    m_frame = new WindowFrame(*this);
    m_frame->build({{m_robots->bar(), GivesWay::LittleByLittle},
                    {m_layouts->bar(), GivesWay::AtOnce},
                    {m_mission->bar()}},
                   {{m_robots->stop()}}, *m_panes);
    m_frame->addBadge(m_preflight->badge());
    m_frame->addBadge(m_features.link->badge(), /*keepsPlace=*/true);
    m_panes->setFocus();  // not STOP, which Space would press
}

void LiveWindow::connectFeatures() {
    const auto watch = [this] { m_bridge.watch(m_selection->name().toStdString()); };
    connect(m_selection, &Selection::changed, this, watch);
    connect(m_features.cameras, &CameraFeature::driveWanted, this, [this] { setDriving(true); });
    connect(m_layouts, &LayoutFeature::padBound, m_pads, &PadFeature::useLayout);
    connect(&m_pads->input(), &PadInput::panTilt, m_features.cameras, [this](const PanTiltRate& rate) {
        const bool joints = m_features.joints != nullptr && m_features.joints->takesStick();
        const PanTiltRate its = joints ? PanTiltRate{} : rate;
        m_features.cameras->setRate(its.pan, -its.tilt);
    });
    if (m_features.joints != nullptr) {
        connect(&m_pads->input(), &PadInput::joints, m_features.joints, &JointsFeature::takeStick);
    }
    connect(&m_pads->input(), &PadInput::padsChanged, m_preflight,
            [this] { m_preflight->setGamepad(QString::fromStdString(m_pads->input().chosen().name)); });
    connect(m_features.alarms, &AlarmsFeature::soundTroubleChanged, m_preflight,
            &PreflightFeature::setSoundTrouble);
    m_preflight->setSoundTrouble(m_features.alarms->soundTrouble());
    connect(m_preflight, &PreflightFeature::tonesWanted, m_features.alarms, &AlarmsFeature::tryTones);
    connect(m_features.alarms, &AlarmsFeature::sounded, this, [this](AlarmTone tone) {
        const bool act = tone == AlarmTone::Act;
        m_pads->input().rumble(act ? StrongRumble : WeakRumble, act ? LongRumble : ShortRumble);
    });
    connect(&m_bridge, &MomentSource::notified, this,
            [this](const QString& text) { m_frame->showMessage(text); });
    watch();
}

MapView& LiveWindow::mapView() const {
    return m_features.map->view();
}

MapViewSettings LiveWindow::view() const {
    MapViewSettings view = m_features.map->settings();
    view.look = m_layouts->ownSight().look;
    return view;
}

void LiveWindow::setLook(MapLook look) {
    m_features.map->show({look, m_features.map->sight().follow});
}

const QString& LiveWindow::selected() const {
    return m_selection->name();
}

bool LiveWindow::driving() const {
    return m_features.drive->driving();
}

void LiveWindow::setDriving(bool on) {
    m_features.drive->setDriving(on);
}

void LiveWindow::showMessage(const QString& text) {
    m_bridge.notify(text);
}

QString LiveWindow::newest() const {
    return m_frame->newest();
}

QStringList LiveWindow::recent() const {
    return m_frame->recent();
}

QString LiveWindow::missing() const {
    QStringList things;
    for (const RobotDescription& robot : m_selection->robots()) {
        const LinkState state = m_bridge.moment().view(robot.name).link.state;
        if (state == LinkState::NeverSeen || state == LinkState::Lost)
            things += tr("%1 is not connected").arg(othersText(robot.title));
    }
    things += m_features.map->missing();
    things += m_features.cameras->missing();
    return things.join(QStringLiteral("; "));
}

void LiveWindow::closeUnasked() {
    m_closing->allow();
    close();
}

void LiveWindow::closeEvent(QCloseEvent* event) {
    if (!m_closing->mayClose()) return event->ignore();
    setDriving(false);
    emit closing();
    QMainWindow::closeEvent(event);
}

}  // namespace leitstand
