#include "app/window/live/live_window.h"

#include <utility>

#include <QApplication>
#include <QCloseEvent>

#include "app/window/commands/command_table.h"
#include "app/window/commands/help_commands.h"
#include "app/window/commands/language_commands.h"
#include "app/window/live/alarms/alarms_feature.h"
#include "app/window/live/cameras/camera_feature.h"
#include "app/window/live/changes/changes_feature.h"
#include "app/window/live/coverage/coverage_feature.h"
#include "app/window/live/drive/drive_feature.h"
#include "app/window/live/frame/closing_question.h"
#include "app/window/live/frame/key_columns.h"
#include "app/window/live/frame/pane_docks.h"
#include "app/window/live/frame/window_frame.h"
#include "app/window/live/input/selection.h"
#include "app/window/live/layouts/layout_feature.h"
#include "app/window/live/layouts/layout_switch.h"
#include "app/window/live/link/link_feature.h"
#include "app/window/live/live_bridge.h"
#include "app/window/live/live_context.h"
#include "app/window/live/map/map_actions.h"
#include "app/window/live/map/map_feature.h"
#include "app/window/live/messages/messages_feature.h"
#include "app/window/live/mission/mission_feature.h"
#include "app/window/live/pad/pad_feature.h"
#include "app/window/live/preflight/preflight_feature.h"
#include "app/window/live/report/report_feature.h"
#include "app/window/live/robots/robots_feature.h"
#include "app/window/live/scan/scan_feature.h"
#include "app/window/live/victims/find_pointing.h"
#include "app/window/live/victims/victims_feature.h"
#include "widgets/models/others_text.h"
#include "widgets/painting/plain_texts.h"
#include "widgets/painting/theme.h"

namespace leitstand {
namespace {

// How a gamepad repeats the tones of alarms.
constexpr double WeakRumble = 0.3, StrongRumble = 0.9;
constexpr int ShortRumble = 200, LongRumble = 600;  ///< [ms]

}  // namespace

LiveWindow::LiveWindow(LiveBridge& bridge, const MapViewSettings& view, LayoutBook layouts, PadMemory pads,
                       QWidget* parent)
    : QMainWindow(parent), m_bridge(bridge) {
    keepTextsPlain();
    applyTheme(*qApp, view.theme);  // before there is a widget that would have to be dressed anew
    setWindowTitle(tr("Leitstand"));
    setWindowIcon(QIcon(QStringLiteral(":/leitstand/icons/leitstand.svg")));
    m_selection = new Selection(bridge.station().robots(), this);
    m_commands = new CommandTable(*this);
    m_panes = new PaneDocks(this);
    const LiveContext context{{m_bridge, *m_selection, *m_commands, *m_panes, *this, &bridge.station()},
                              m_bridge};
    // Each of these makes its panes and commands; the layouts come last, which place and bind them.
    m_mission = new MissionFeature(context, QString::fromStdString(bridge.station().folder()));
    m_robots = new RobotsFeature(context);
    m_drive = new DriveFeature(context);
    m_cameras = new CameraFeature(context);
    m_map = new MapFeature(context, view);
    auto* mapActions = new MapActions(context, *m_map);
    connect(mapActions, &MapActions::told, this, &LiveWindow::tell);
    connect(&m_drive->input(), &DriveInput::halted, mapActions, &MapActions::halt);
    auto* coverage = new CoverageFeature(
        context, *m_map, [&bridge](const LiveMoment&) { return bridge.station().searched(); }, mapActions);
    connect(coverage, &CoverageFeature::told, this, &LiveWindow::tell);
    auto* const changes = new ChangesFeature(context, *m_map);
    connect(changes, &ChangesFeature::told, this, &LiveWindow::tell);
    auto* scan = new ScanFeature(context);
    m_victims = new VictimsFeature(context, *m_map, *m_cameras);
    auto* pointing = new FindPointing(context, *m_map, *m_cameras, *scan);
    connect(pointing, &FindPointing::told, this, &LiveWindow::tell);
    m_report = new ReportFeature(context);
    m_pads = new PadFeature(context, m_drive->input(), std::move(pads));
    m_link = new LinkFeature(context);
    m_preflight = new PreflightFeature(context);
    m_alarms = new AlarmsFeature(context);
    m_messages = new MessagesFeature(context);
    m_closing = new ClosingQuestion(context);
    addLanguageCommands(*m_commands, [this](const QString& code) { emit languageWanted(code); });
    m_layouts = new LayoutFeature(context, std::move(layouts), *m_map);
    (new HelpCommands(*this, KeyColumns::live()))->fill(m_commands->menu(CommandMenu::Help));
    m_commands->adopt(CommandMenu::Help);
    build();
    connectFeatures();
    m_bridge.showAgain();
    m_layouts->use(QStringLiteral("drive"));
}

LiveWindow::~LiveWindow() {
    setDriving(false);
    // What its parts still say while they go has nobody to hear it.
    for (QObject* part : children()) part->disconnect(this);
}

void LiveWindow::build() {
    m_frame = new WindowFrame(*this);
    m_frame->build({{m_robots->bar(), GivesWay::LittleByLittle},
                    {m_layouts->bar(), GivesWay::AtOnce},
                    {m_mission->bar()}},
                   {{m_robots->stop()}}, *m_panes);
    m_frame->addBadge(m_preflight->badge());
    m_frame->addBadge(m_link->badge(), /*keepsPlace=*/true);
    m_panes->setFocus();  // and not STOP, which Space would press
}

void LiveWindow::connectFeatures() {
    const auto watch = [this] { m_bridge.watch(m_selection->name().toStdString()); };
    connect(m_selection, &Selection::changed, this, watch);
    connect(m_cameras, &CameraFeature::driveWanted, this, [this] { setDriving(true); });
    connect(m_cameras, &CameraFeature::told, this, &LiveWindow::tell);
    connect(m_robots, &RobotsFeature::told, this, &LiveWindow::tell);
    connect(m_mission, &MissionFeature::told, this, &LiveWindow::tell);
    connect(m_victims, &VictimsFeature::told, this, &LiveWindow::tell);
    connect(m_report, &ReportFeature::told, this, &LiveWindow::tell);
    connect(m_layouts, &LayoutFeature::told, this, &LiveWindow::tell);
    connect(m_layouts, &LayoutFeature::padBound, m_pads, &PadFeature::useLayout);
    connect(m_pads, &PadFeature::told, this, &LiveWindow::tell);
    connect(m_link, &LinkFeature::told, this, &LiveWindow::tell);
    connect(&m_pads->input(), &PadInput::panTilt, m_cameras,
            [this](const PanTiltRate& rate) { m_cameras->setRate(rate.pan, -rate.tilt); });
    connect(&m_pads->input(), &PadInput::padsChanged, m_preflight,
            [this] { m_preflight->setGamepad(QString::fromStdString(m_pads->input().chosen().name)); });
    connect(m_alarms, &AlarmsFeature::soundTroubleChanged, m_preflight, &PreflightFeature::setSoundTrouble);
    m_preflight->setSoundTrouble(m_alarms->soundTrouble());
    connect(m_preflight, &PreflightFeature::tonesWanted, m_alarms, &AlarmsFeature::tryTones);
    connect(m_alarms, &AlarmsFeature::sounded, this, [this](AlarmTone tone) {
        const bool act = tone == AlarmTone::Act;
        m_pads->input().rumble(act ? StrongRumble : WeakRumble, act ? LongRumble : ShortRumble);
    });
    connect(&m_bridge, &LiveBridge::told, this, &LiveWindow::tell);
    watch();
}

MapView& LiveWindow::mapView() const {
    return m_map->view();
}

MapViewSettings LiveWindow::view() const {
    MapViewSettings view = m_map->settings();
    view.look = m_layouts->ownSight().look;
    return view;
}

void LiveWindow::setLook(MapLook look) {
    m_map->show({look, m_map->sight().follow});
}

const QString& LiveWindow::selected() const {
    return m_selection->name();
}

bool LiveWindow::driving() const {
    return m_drive->driving();
}

void LiveWindow::setDriving(bool on) {
    m_drive->setDriving(on);
}

void LiveWindow::tell(const QString& text) {
    m_frame->tell(text);
    m_messages->add(text);
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
    things += m_map->missing();
    things += m_cameras->missing();
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
