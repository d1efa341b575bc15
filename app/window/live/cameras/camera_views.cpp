#include "app/window/live/cameras/camera_views.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <variant>

#include <QAction>
#include <QMainWindow>

#include "app/window/commands/command_table.h"
#include "app/window/live/live_bridge.h"
#include "app/window/live/pane_docks.h"
#include "app/window/live/selection.h"
#include "widgets/camera/camera_pane.h"
#include "widgets/models/live/drive_state.h"
#include "widgets/models/live/mode_label.h"
#include "widgets/models/live/proximity.h"
#include "widgets/models/live/sight_text.h"

namespace leitstand {
namespace {

/// Cameras of a robot in its file's order, the thermal ones last.
std::vector<std::string> camerasOf(const RobotDescription& robot) {
    std::vector<std::string> cameras;
    for (const StreamRole role : {StreamRole::Picture, StreamRole::Thermal}) {
        for (const StreamDescription& stream : robot.streams) {
            if (stream.role == role) cameras.push_back(stream.sensor);
        }
    }
    return cameras;
}

QString titleOf(const std::string& sensor) {
    if (sensor == "left") return CameraViews::tr("Left camera");
    if (sensor == "right") return CameraViews::tr("Right camera");
    if (sensor == "omni") return CameraViews::tr("Omnidirectional camera");
    if (sensor == "ir") return CameraViews::tr("Infrared °C");
    return sensor.empty() ? CameraViews::tr("No camera") : QString::fromStdString(sensor);
}

}  // namespace

CameraViews::CameraViews(const LiveContext& context)
    : QObject(&context.window),
      m_context(context),
      m_large(new CameraPane(&context.window)),
      m_small(new CameraPane(&context.window)) {
    m_large->setObjectName(QStringLiteral("cameraPane"));
    m_small->setObjectName(QStringLiteral("rightPane"));
    context.panes.add(QStringLiteral("camera"), tr("Camera"), *m_large);
    context.panes.add(QStringLiteral("right"), tr("Second camera"), *m_small);
    QAction& nextOne =
        context.commands.add({.id = "camera.next",
                              .menu = CommandMenu::Cameras,
                              .text = tr("&Next small picture"),
                              .hint = tr("Shows the next camera of the robot in the small pane"),
                              .keys = QKeySequence(Qt::Key_I)});
    connect(&nextOne, &QAction::triggered, this, &CameraViews::next);
    connect(m_large, &CameraPane::pictureClicked, this, &CameraViews::driveWanted);
    connect(&context.selection, &Selection::changed, this, &CameraViews::choose);
    connect(&context.bridge, &LiveBridge::pictured, this, &CameraViews::showPicture);
    connect(&context.bridge, &LiveBridge::ticked, this, &CameraViews::show);
    choose();
}

void CameraViews::choose() {
    const RobotDescription* const robot = m_context.selection.robot();
    if (robot == nullptr) return;
    const auto cameras = camerasOf(*robot);
    m_largeSensor = cameras.empty() ? std::string() : cameras.front();
    m_smallSensor = cameras.size() > 1 ? cameras.back() : std::string();
    for (CameraPane* pane : {m_large, m_small}) pane->setPicture({});
    m_small->setThermal(nullptr);
    for (const std::string& sensor : {m_largeSensor, m_smallSensor}) showNewest(sensor);
}

void CameraViews::next() {
    const RobotDescription* const robot = m_context.selection.robot();
    if (robot == nullptr) return;
    const auto cameras = camerasOf(*robot);
    const auto now = std::find(cameras.begin(), cameras.end(), m_smallSensor);
    if (cameras.size() < 2 || now == cameras.end()) return;
    // The next one that is not large.
    std::size_t place = static_cast<std::size_t>(now - cameras.begin());
    do {
        place = (place + 1) % cameras.size();
    } while (cameras[place] == m_largeSensor);
    m_smallSensor = cameras[place];
    m_small->setPicture({});
    m_small->setThermal(nullptr);
    showNewest(m_smallSensor);
}

void CameraViews::showNewest(const std::string& sensor) {
    const auto camera = m_cameras.find({m_context.selection.name().toStdString(), sensor});
    if (camera != m_cameras.end() && camera->second.newest) showPicture(camera->second.newest);
}

void CameraViews::showIn(CameraPane& pane, const ShownPicture& picture) {
    if (const auto* heat = std::get_if<ThermalPicture>(&picture.content)) {
        pane.setThermal(std::make_shared<const ThermalPicture>(*heat));
    } else {
        pane.setPicture(imageOf(std::get<Picture>(picture.content)));
    }
}

void CameraViews::showPicture(const ShownPicturePtr& picture) {
    Camera& camera = m_cameras[{picture->robot, picture->sensor}];
    if (camera.newest != picture) {
        camera.age.arrived(picture->fingerprint, std::chrono::steady_clock::now());
        camera.newest = picture;
    }
    if (picture->robot != m_context.selection.name().toStdString()) return;
    if (picture->sensor == m_largeSensor) showIn(*m_large, *picture);
    if (picture->sensor == m_smallSensor) showIn(*m_small, *picture);
}

void CameraViews::showAge(CameraPane& pane, const std::string& sensor, const LiveMoment& moment) {
    const auto camera = m_cameras.find({m_context.selection.name().toStdString(), sensor});
    pane.setCamera(m_context.selection.face(), titleOf(sensor));
    pane.setAge(camera == m_cameras.end() ? DataAge{} : camera->second.age.at(moment.steady),
                &pane == m_large ? sightNote(moment.view(m_context.selection.name().toStdString()).drive)
                                 : QString());
}

CameraOverlay CameraViews::overlay(const RobotDescription& robot, const LiveMoment& moment) const {
    const RobotView& view = moment.view(robot.name);
    const RobotState& said = moment.said(robot.name);
    CameraOverlay overlay;
    overlay.mode = modeLabelOf(view, said.mode);
    if (const auto attitude = rollAndPitch(robot, said, moment.now)) {
        overlay.roll = attitude->first;
        overlay.pitch = attitude->second;
    }
    if (view.around)
        overlay.ring = proximityRing(*view.around, boxAround(robot.footprint), view.drive.velocity);
    overlay.moving = !isZero(view.drive.velocity);
    return overlay;
}

void CameraViews::show(const LiveMoment& moment) {
    const RobotDescription* const robot = m_context.selection.robot();
    if (robot == nullptr) return;
    showAge(*m_large, m_largeSensor, moment);
    showAge(*m_small, m_smallSensor, moment);
    m_large->setOverlay(overlay(*robot, moment));
}

QStringList CameraViews::missing() const {
    QStringList things;
    for (const std::string& sensor : {m_largeSensor, m_smallSensor}) {
        if (!sensor.empty() && !m_cameras.contains({m_context.selection.name().toStdString(), sensor}))
            things += tr("no picture of %1").arg(titleOf(sensor));
    }
    return things;
}

}  // namespace leitstand
