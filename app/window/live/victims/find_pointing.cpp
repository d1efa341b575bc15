#include "app/window/live/victims/find_pointing.h"

#include <optional>
#include <string>

#include <QAction>
#include <QMainWindow>

#include "app/session/finds/find_desk.h"
#include "app/session/station/station.h"
#include "app/session/station/station_mapping.h"
#include "app/window/commands/command_table.h"
#include "app/window/live/cameras/camera_feature.h"
#include "app/window/live/live_bridge.h"
#include "app/window/live/map/map_feature.h"
#include "app/window/live/map/map_gestures.h"
#include "app/window/live/map/robots_on_map.h"
#include "app/window/live/scan/scan_feature.h"
#include "app/window/live/selection.h"
#include "widgets/models/map/robot_mark.h"

namespace leitstand {
namespace {

constexpr double LyingHeight =
    0.2;  ///< of a body's middle above the ground, where the height is not told [m]

}  // namespace

FindPointing::FindPointing(const LiveContext& context, MapFeature& map, CameraFeature& cameras,
                           ScanFeature& scan)
    : QObject(&context.window),
      m_context(context),
      m_map(map),
      m_cameras(cameras),
      m_scan(scan),
      m_action(&context.commands.add(
          {.id = QStringLiteral("victim.point"),
           .menu = CommandMenu::Mission,
           .text = tr("Victim where I &click"),
           .hint = tr("Then click on it in a picture, in the virtual scan or on the map; in pictures and the "
                      "virtual scan a click with Shift does the same at any time"),
           .keys = QKeySequence(Qt::SHIFT | Qt::Key_F),
           .checkable = true})) {
    connect(m_action, &QAction::triggered, this, &FindPointing::arm);
    connect(m_action, &QAction::toggled, this, [this](bool on) {
        m_cameras.setPointing(on);
        m_scan.setPointing(on);
    });
    const auto end = [this] {
        if (m_action->isChecked()) m_map.gestures().disarm();
    };
    connect(&context.selection, &Selection::changed, this, end);  // the ghost is the other robot's
    connect(&cameras, &CameraFeature::pointed, this, &FindPointing::fileIn);
    connect(&cameras, &CameraFeature::pointed, this, end);
    connect(&cameras, &CameraFeature::pointingEnded, this, end);
    connect(&scan, &ScanFeature::pointed, this, &FindPointing::fileBeside);
    connect(&scan, &ScanFeature::pointed, this, end);
    connect(&scan, &ScanFeature::pointingEnded, this, end);
}

void FindPointing::arm(bool on) {
    if (!on) return m_map.gestures().disarm();
    RobotMark mark = m_map.robots().mark(m_context.selection.name().toStdString());
    mark.footprint = {{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}};
    mark.height = LyingHeight;
    m_map.gestures().armPose(*m_action, mark, tr("Click where the victim is · right button: not at all"),
                             [this](const GroundPose& pose) { fileAt(pose.place); });
    emit told(tr("Click on the victim: in a picture, in the virtual scan or on the map"));
}

void FindPointing::fileIn(const PicturePoint& at) {
    m_context.bridge.station().finds().freeze(m_context.selection.name().toStdString(),
                                              VictimSample::Kind::Victim, {}, at);
}

void FindPointing::fileBeside(const Eigen::Vector2d& placeInBase) {
    const std::string name = m_context.selection.name().toStdString();
    std::optional<Pose> baseInMap;
    for (const RobotInMap& robot : *m_context.bridge.station().mapping().robots()) {
        if (robot.robot == name && robot.placed) baseInMap = robot.baseInMap;
    }
    if (!baseInMap) return emit told(tr("The robot is not in the map yet: nothing was filed"));
    fileAt(*baseInMap * Eigen::Vector3d(placeInBase.x(), placeInBase.y(), LyingHeight));
}

void FindPointing::fileAt(const Eigen::Vector3d& placeInMap) {
    m_context.bridge.station().finds().freezeAt(m_context.selection.name().toStdString(),
                                                VictimSample::Kind::Victim, placeInMap);
}

}  // namespace leitstand
