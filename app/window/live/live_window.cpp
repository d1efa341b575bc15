#include "app/window/live/live_window.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>
#include <variant>

#include <QAction>
#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenuBar>
#include <QSplitter>
#include <QVBoxLayout>

#include "app/session/log/sequencer.h"
#include "app/window/commands/help_commands.h"
#include "app/window/commands/view_commands.h"
#include "app/window/live/robot_commands.h"
#include "app/window/live/stop_key.h"
#include "app/window/map_pane.h"
#include "core/mission/mission_state.h"
#include "widgets/camera/camera_pane.h"
#include "widgets/drive/drive_strip.h"
#include "widgets/drive/stop_button.h"
#include "widgets/map_view/map_view.h"
#include "widgets/models/live/drive_state.h"
#include "widgets/models/live/robot_chip.h"
#include "widgets/models/live/stop_line.h"
#include "widgets/models/map_summary.h"
#include "widgets/robots/robot_bar.h"
#include "widgets/theme.h"
#include "widgets/virtual_scan/virtual_scan_pane.h"

namespace leitstand {
namespace {

constexpr int Half = 1'000;  ///< sizes of splitters are shares

const MapViewSettings& themed(const MapViewSettings& view) {
    applyTheme(*qApp, view.theme);
    return view;
}

/// Since the newest scan of @p said came [s]; infinite: never.
double scanAge(const RobotState& said, Time now) {
    double age = std::numeric_limits<double>::infinity();
    for (const auto& [topic, stream] : said.streams) {
        if (stream.role != StreamRole::Points && stream.role != StreamRole::Ranges) continue;
        age = std::min(age, std::chrono::duration<double>(now - stream.received).count());
    }
    return age;
}

const RobotState& saidBy(const MissionState& mission, const std::string& robot) {
    static const RobotState nothing;
    const auto found = mission.robots.find(robot);
    return found == mission.robots.end() ? nothing : *found->second;
}

}  // namespace

LiveWindow::LiveWindow(LiveBridge& bridge, const MapViewSettings& view, QWidget* parent)
    : QMainWindow(parent), m_bridge(bridge), m_view(themed(view)) {
    setWindowTitle(tr("Leitstand"));
    setWindowIcon(QIcon(QStringLiteral(":/leitstand/icons/leitstand.svg")));
    build();
    addCommands();
    connectBridge();
    connectPanes();
    if (!m_bridge.station().robots().empty())
        select(QString::fromStdString(m_bridge.station().robots().front().name));
}

LiveWindow::~LiveWindow() = default;

MapView& LiveWindow::mapView() const {
    return m_map->view();
}

void LiveWindow::build() {
    m_map = new MapPane(m_view, this);
    m_map->setHelpVisible(false);
    m_camera = new CameraPane(this);
    m_camera->setObjectName(QStringLiteral("camera"));
    m_right = new CameraPane(this);
    m_right->setObjectName(QStringLiteral("right"));
    m_scan = new VirtualScanPane(this);
    m_strip = new DriveStrip(this);
    m_bar = new RobotBar(this);
    m_stop = new StopButton(this);
    m_word = new QLabel(this);
    m_word->setObjectName(QStringLiteral("word"));
    m_word->setProperty("muted", true);

    auto* top = new QWidget(this);
    top->setAttribute(Qt::WA_StyledBackground);
    auto* bar = new QHBoxLayout(top);
    bar->setContentsMargins(8, 6, 8, 6);
    bar->addWidget(m_bar);
    bar->addWidget(m_word, 1);
    bar->addWidget(m_stop);

    auto* low = new QSplitter(Qt::Horizontal, this);
    low->addWidget(m_scan);
    low->addWidget(m_right);
    m_side = new QSplitter(Qt::Vertical, this);
    m_side->addWidget(m_map);
    m_side->addWidget(low);
    m_big = new QSplitter(Qt::Horizontal, this);
    m_big->addWidget(m_camera);
    m_big->addWidget(m_side);
    m_big->setStretchFactor(0, 5);
    m_big->setStretchFactor(1, 3);
    for (QSplitter* splitter : {low, m_side, m_big}) splitter->setChildrenCollapsible(false);
    low->setSizes({Half, Half});
    m_side->setSizes({Half, Half});

    auto* whole = new QWidget(this);
    auto* rows = new QVBoxLayout(whole);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(top);
    rows->addWidget(m_big, 1);
    rows->addWidget(m_strip);
    setCentralWidget(whole);
}

void LiveWindow::addCommands() {
    auto* stopKey = new StopKey(this);
    connect(stopKey, &StopKey::pressed, this, [this] { m_bridge.station().stopAll(); });
    auto* robots = new RobotCommands(m_bridge, *this);
    connect(robots, &RobotCommands::selected, this, &LiveWindow::select);
    connect(robots, &RobotCommands::drivingWanted, this, &LiveWindow::setDriving);
    connect(robots, &RobotCommands::swapWanted, this, &LiveWindow::swapViews);
    connect(robots, &RobotCommands::rightViewWanted, this, &LiveWindow::toggleRight);
    connect(robots, &RobotCommands::failed, this, &LiveWindow::tell);
    connect(&m_input, &DriveInput::focusChanged, robots, &RobotCommands::showDriving);
    robots->fill(*menuBar()->addMenu(tr("&Robot")), [this] { return m_selected; });
    auto* view = new ViewCommands(m_view, mapView(), this, Qt::AltModifier);  // 1, 2 ... select robots
    view->fill(*menuBar()->addMenu(tr("&View")));
    view->setScans(0);
    view->before().setVisible(false);  // scans of a live map have one pose
    connect(&m_bridge, &LiveBridge::mapChanged, view,
            [view](const MapPtr& map) { view->setScans(static_cast<int>(map->scans.size())); });
    (new HelpCommands(*this))->fill(*menuBar()->addMenu(tr("&Help")));
}

void LiveWindow::connectBridge() {
    connect(&m_bridge, &LiveBridge::ticked, this, &LiveWindow::refresh);
    connect(&m_bridge, &LiveBridge::pictured, this, &LiveWindow::showPicture);
    connect(&m_bridge, &LiveBridge::told, this, &LiveWindow::tell);
    connect(&m_bridge, &LiveBridge::mapChanged, this, [this](const MapPtr& map) {
        m_mapSeen = m_mapSeen || !map->scans.empty();
        mapView().setMap(map);
        m_map->setSummary(summaryOf(*map));
    });
    connect(&m_view, &ViewState::changed, this, [this](const MapViewSettings& settings) {
        if (settings.theme != mapView().settings().theme) applyTheme(*qApp, settings.theme);
        mapView().setSettings(settings);
    });
    mapView().setSettings(m_view.settings());
}

void LiveWindow::connectPanes() {
    Station& station = m_bridge.station();
    connect(m_bar, &RobotBar::robotSelected, this, &LiveWindow::select);
    connect(m_stop, &StopButton::stopRequested, this, [&station] { station.stopAll(); });
    connect(m_stop, &StopButton::releaseRequested, this, [this, &station](const QString& robot) {
        if (const auto let = station.release(robot.toStdString()); !let)
            tell(QString::fromStdString(let.error().text));
    });
    connect(m_strip, &DriveStrip::grantAsked, this,
            [this, &station] { station.ask(m_selected.toStdString()); });
    connect(m_strip, &DriveStrip::grantGivenUp, this, [this, &station] {
        setDriving(false);
        station.giveUp(m_selected.toStdString());
    });
    connect(m_strip, &DriveStrip::grantAnswered, this,
            [this, &station](bool consent) { station.answer(m_selected.toStdString(), consent); });
    connect(m_camera, &CameraPane::pictureClicked, this, [this](double, double) { setDriving(true); });
    connect(&m_input, &DriveInput::sticks, this,
            [&station](const DriveVelocity& sticks) { station.push(sticks); });
    connect(&m_input, &DriveInput::focusChanged, this, [this, &station](bool focus) {
        station.focus(focus ? m_selected.toStdString() : std::string());
    });
}

const RobotDescription* LiveWindow::description(const QString& robot) const {
    const auto& robots = m_bridge.station().robots();
    const auto found =
        std::find_if(robots.begin(), robots.end(),
                     [name = robot.toStdString()](const auto& one) { return one.name == name; });
    return found == robots.end() ? nullptr : &*found;
}

int LiveWindow::placeOf(const QString& robot) const {
    const RobotDescription* const found = description(robot);
    return found == nullptr ? 0 : static_cast<int>(found - m_bridge.station().robots().data());
}

std::vector<const StreamDescription*> LiveWindow::camerasOf(const RobotDescription& robot) const {
    std::vector<const StreamDescription*> cameras;
    for (const StreamRole role : {StreamRole::Picture, StreamRole::Thermal}) {
        for (const StreamDescription& stream : robot.streams) {
            if (stream.role == role) cameras.push_back(&stream);
        }
    }
    return cameras;
}

void LiveWindow::select(const QString& robot) {
    const RobotDescription* const found = description(robot);
    if (found == nullptr || robot == m_selected) return;
    m_selected = robot;
    m_input.setRobot(*found);
    const auto cameras = camerasOf(*found);
    m_large = cameras.empty() ? std::string() : cameras.front()->sensor;
    m_small = cameras.size() > 1 ? cameras.back()->sensor : std::string();
    const RobotFace face = faceOf(*found, placeOf(robot));
    m_scan->setRobot(face, found->footprint);
    for (CameraPane* pane : {m_camera, m_right}) pane->setPicture({});
    m_right->setThermal(nullptr);
    for (const auto& [camera, state] : m_cameras) {
        if (camera.first == found->name && state.newest) showPicture(state.newest);
    }
    refresh();
}

void LiveWindow::setDriving(bool on) {
    if (on) m_bridge.station().ask(m_selected.toStdString());
    m_input.setFocus(on);
}

void LiveWindow::swapViews() {
    const QList<int> wide = m_big->sizes(), high = m_side->sizes();
    const bool cameraIsBig = m_big->indexOf(m_camera) == 0;
    QWidget* const grows = cameraIsBig ? static_cast<QWidget*>(m_map) : m_camera;
    QWidget* const shrinks = cameraIsBig ? static_cast<QWidget*>(m_camera) : m_map;
    m_side->insertWidget(0, shrinks);
    m_big->insertWidget(0, grows);
    m_big->setSizes(wide);
    m_side->setSizes(high);
}

void LiveWindow::toggleRight() {
    const RobotDescription* const robot = description(m_selected);
    if (robot == nullptr) return;
    const auto cameras = camerasOf(*robot);
    const auto now = std::find_if(cameras.begin(), cameras.end(),
                                  [this](const auto* stream) { return stream->sensor == m_small; });
    if (cameras.size() < 2 || now == cameras.end()) return;
    // The next one that is not large.
    std::size_t next = static_cast<std::size_t>(now - cameras.begin());
    do {
        next = (next + 1) % cameras.size();
    } while (cameras[next]->sensor == m_large);
    m_small = cameras[next]->sensor;
    m_right->setPicture({});
    m_right->setThermal(nullptr);
    const auto newest = m_cameras.find({robot->name, m_small});
    if (newest != m_cameras.end() && newest->second.newest) showPicture(newest->second.newest);
}

void LiveWindow::showIn(CameraPane& pane, const ShownPicture& picture) {
    if (const auto* heat = std::get_if<ThermalPicture>(&picture.content)) {
        pane.setThermal(std::make_shared<const ThermalPicture>(*heat));
    } else {
        pane.setPicture(imageOf(std::get<Picture>(picture.content)));
    }
}

void LiveWindow::showPicture(const ShownPicturePtr& picture) {
    Camera& camera = m_cameras[{picture->robot, picture->sensor}];
    if (camera.newest != picture) {
        camera.age.arrived(picture->fingerprint, std::chrono::steady_clock::now());
        camera.newest = picture;
    }
    if (picture->robot != m_selected.toStdString()) return;
    if (picture->sensor == m_large) showIn(*m_camera, *picture);
    if (picture->sensor == m_small) showIn(*m_right, *picture);
}

void LiveWindow::tell(const QString& text) {
    m_word->setText(text);
    m_word->setToolTip(text);
}

void LiveWindow::refresh() {
    const MissionStatePtr mission = m_bridge.station().mission();
    std::vector<RobotChip> chips;
    std::vector<StopLine> stops;
    int place = 0;
    for (const RobotDescription& robot : m_bridge.station().robots()) {
        const RobotView view = m_bridge.station().robot(robot.name);
        const RobotState& said = saidBy(*mission, robot.name);
        const RobotFace face = faceOf(robot, place++);
        chips.push_back(robotChipOf(face, view, said));
        stops.push_back(stopLineOf(face, view));
        if (said.gas) m_gas[robot.name].add(said.gas->received, said.gas->sample.ppm);
        if (face.name == m_selected) refreshPanes(robot, view, said);
    }
    m_bar->show(chips, m_selected);
    m_stop->show(stops);
}

void LiveWindow::refreshPanes(const RobotDescription& robot, const RobotView& view, const RobotState& said) {
    const Time now = stationTime();
    const auto steady = std::chrono::steady_clock::now();
    const RobotFace face = faceOf(robot, placeOf(m_selected));
    m_strip->show(driveStateOf(face, robot, view, said, m_gas[robot.name], now));
    m_scan->show(view.around, view.drive.velocity, scanAge(said, now));
    const auto aged = [&](CameraPane& pane, const std::string& sensor) {
        const auto camera = m_cameras.find({robot.name, sensor});
        pane.setCamera(face, cameraTitle(sensor));
        pane.setAge(camera == m_cameras.end() ? DataAge{} : camera->second.age.at(steady));
    };
    aged(*m_camera, m_large);
    aged(*m_right, m_small);
    CameraOverlay overlay;
    overlay.mode = modeLabelOf(view, said.mode);
    if (const auto attitude = rollAndPitch(robot, said, now)) {
        overlay.roll = attitude->first;
        overlay.pitch = attitude->second;
    }
    if (view.around)
        overlay.ring = proximityRing(*view.around, boxAround(robot.footprint), view.drive.velocity);
    overlay.moving = !isZero(view.drive.velocity);
    m_camera->setOverlay(overlay);
}

QString LiveWindow::cameraTitle(const std::string& sensor) {
    if (sensor == "left") return tr("Left camera");
    if (sensor == "right") return tr("Right camera");
    if (sensor == "omni") return tr("Omnidirectional camera");
    if (sensor == "ir") return tr("Infrared °C");
    return sensor.empty() ? tr("No camera") : QString::fromStdString(sensor);
}

QString LiveWindow::missing() const {
    QStringList things;
    for (const RobotDescription& robot : m_bridge.station().robots()) {
        const QString title = QString::fromStdString(robot.title);
        if (m_bridge.station().robot(robot.name).link.state != LinkState::Connected)
            things += tr("%1 is not connected").arg(title);
    }
    if (!m_mapSeen || !mapView().settled()) things += tr("no scan is registered and drawn");
    for (const std::string& sensor : {m_large, m_small}) {
        if (!sensor.empty() && !m_cameras.contains({m_selected.toStdString(), sensor}))
            things += tr("no picture of %1").arg(cameraTitle(sensor));
    }
    return things.join(QStringLiteral("; "));
}

void LiveWindow::closeEvent(QCloseEvent* event) {
    setDriving(false);
    QMainWindow::closeEvent(event);
}

}  // namespace leitstand
