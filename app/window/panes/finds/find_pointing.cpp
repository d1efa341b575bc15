#include "app/window/panes/finds/find_pointing.h"

#include <algorithm>
#include <optional>
#include <string>

#include <QAction>
#include <QMainWindow>

#include "app/services/finds/find_desk.h"
#include "app/services/station/station.h"
#include "app/services/station/station_mapping.h"
#include "app/window/commands/command_table.h"
#include "app/window/input/selection.h"
#include "app/window/panes/camera/camera_feature.h"
#include "app/window/panes/map/map_feature.h"
#include "app/window/panes/map/map_gestures.h"
#include "app/window/panes/map/robots_on_map.h"
#include "app/window/panes/scan/scan_feature.h"
#include "app/window/source/moment_source.h"
#include "core/event/find_sample.h"
#include "core/mission/finds/find_book.h"
#include "widgets/models/map/robots/robot_mark.h"

namespace leitstand {

FindPointing::FindPointing(const LiveContext& context, MapFeature& map, CameraFeature& cameras,
                           ScanFeature& scan)
    : QObject(&context.window), m_context(context), m_map(map), m_cameras(cameras), m_scan(scan) {
    using Kind = FindSample::Kind;
    add("victim.point", Kind::Victim, tr("Victim where I &click"),
        tr("Then click on it in a picture, in the virtual scan or on the map; in pictures and the "
           "virtual scan a click with Shift does the same at any time"),
        QKeySequence(Qt::SHIFT | Qt::Key_F));
    const QString clickHint = tr("Then click on it in a picture, in the virtual scan or on the map");
    add("victim.pointHazard", Kind::Hazard, tr("Hazard where I click"), clickHint);
    add("victim.pointCode", Kind::Code, tr("QR code where I click"), clickHint);
    add("victim.pointObject", Kind::Object, tr("Object where I click"), clickHint);
    const auto end = [this] {
        if (armed()) m_map.gestures().disarm();
    };
    connect(&context.selection, &Selection::changed, this, end);  // the ghost belongs to the other robot
    connect(&cameras, &CameraFeature::pointed, this, &FindPointing::fileIn);
    connect(&cameras, &CameraFeature::pointed, this, end);
    connect(&cameras, &CameraFeature::pointingEnded, this, end);
    connect(&scan, &ScanFeature::pointed, this, &FindPointing::fileBeside);
    connect(&scan, &ScanFeature::pointed, this, end);
    connect(&scan, &ScanFeature::pointingEnded, this, end);
}

void FindPointing::add(const char* id, FindSample::Kind kind, const QString& text, const QString& hint,
                       const QKeySequence& keys) {
    QAction& action = m_context.commands.add({.id = QString::fromLatin1(id),
                                              .menu = CommandMenu::Mission,
                                              .text = text,
                                              .hint = hint,
                                              .keys = keys,
                                              .checkable = true});
    m_actions.emplace_back(kind, &action);
    connect(&action, &QAction::triggered, this, [this, &action, kind](bool on) { arm(action, kind, on); });
    connect(&action, &QAction::toggled, this, [this] {
        m_cameras.setPointing(armed());
        m_scan.setPointing(armed());
    });
}

bool FindPointing::armed() const {
    return std::any_of(m_actions.begin(), m_actions.end(),
                       [](const auto& one) { return one.second->isChecked(); });
}

FindSample::Kind FindPointing::kind() const {
    for (const auto& [kind, action] : m_actions) {
        if (action->isChecked()) return kind;
    }
    return FindSample::Kind::Victim;
}

void FindPointing::arm(QAction& action, FindSample::Kind kind, bool on) {
    if (!on) return m_map.gestures().disarm();
    RobotMark mark = m_map.robots().mark(m_context.selection.name().toStdString());
    mark.footprint = {{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}};
    mark.height = LyingHeight;
    const bool victim = kind == FindSample::Kind::Victim;
    m_map.gestures().armPose(action, mark,
                             victim ? tr("Click where the victim is · right button: not at all")
                                    : tr("Click where it is · right button: not at all"),
                             [this, kind](const GroundPose& pose) { fileAt(aboveFloor(pose.place), kind); });
    m_context.notify(victim ? tr("Click on the victim: in a picture, in the virtual scan or on the map")
                            : tr("Click on it: in a picture, in the virtual scan or on the map"));
}

void FindPointing::fileIn(const PicturePoint& at) {
    m_context.station.finds().freeze(m_context.selection.name().toStdString(), kind(), {}, at);
}

void FindPointing::fileBeside(const Eigen::Vector2d& placeInBase) {
    const std::string name = m_context.selection.name().toStdString();
    std::optional<Pose> baseInMap;
    const RobotsInMapPtr robots = m_context.station.mapping().robots();
    for (const RobotInMap& robot : *robots) {
        if (robot.robot == name && robot.placed) baseInMap = robot.baseInMap;
    }
    if (!baseInMap) return m_context.notify(tr("The robot is not in the map yet: nothing was filed"));
    fileAt(*baseInMap * Eigen::Vector3d(placeInBase.x(), placeInBase.y(), LyingHeight), kind());
}

void FindPointing::fileAt(const Eigen::Vector3d& placeInMap, FindSample::Kind kind) {
    m_context.station.finds().freezeAt(m_context.selection.name().toStdString(), kind, placeInMap);
}

}  // namespace leitstand
