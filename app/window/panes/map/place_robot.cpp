#include "app/window/panes/map/place_robot.h"

#include <QAction>

#include "app/services/station/station.h"
#include "app/services/station/station_mapping.h"
#include "app/window/commands/command_table.h"
#include "app/window/input/selection.h"
#include "app/window/panes/map/map_gestures.h"
#include "app/window/panes/map/robots_on_map.h"
#include "app/window/source/moment_source.h"
#include "core/base/rotation/heading.h"

namespace leitstand {

PlaceRobot::PlaceRobot(const LiveContext& context, MapGestures& gestures, RobotsOnMap& robots,
                       QObject* parent)
    : QObject(parent),
      m_context(context),
      m_gestures(gestures),
      m_robots(robots),
      m_action(&context.commands.add(
          {.id = "map.placeRobot",
           .menu = CommandMenu::Map,
           .text = tr("P&lace a robot"),
           .hint = tr(
               "Click on the map where a robot stands that is not in it yet, or the selected one; drag its "
               "heading"),
           .keys = QKeySequence(Qt::SHIFT | Qt::Key_O),
           .checkable = true})) {
    connect(m_action, &QAction::triggered, this, &PlaceRobot::arm);
    QAction& look = context.commands.add(
        {.id = "map.findRobot",
         .menu = CommandMenu::Map,
         .text = tr("F&ind the robot in the whole map"),
         .hint =
             tr("Looks by the newest 3D scan of the selected robot for where it stands, anywhere in the map: "
                "for one that was carried or is lost"),
         .keys = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O)});
    connect(&look, &QAction::triggered, this, &PlaceRobot::lookFor);
}

void PlaceRobot::lookFor() {
    const RobotDescription* const robot = m_context.selection.robot();
    if (robot == nullptr) return;
    const auto looking = m_context.station.mapping().lookFor(robot->name);
    if (!looking) m_context.notify(QString::fromStdString(looking.error().text));
}

void PlaceRobot::arm(bool on) {
    if (!on) return m_gestures.disarm();
    const std::string robot = m_robots.toPlace();
    const RobotMark mark = m_robots.mark(robot);
    m_gestures.armPose(
        *m_action, mark,
        tr("Click where %1 stands, drag its heading · right button: not at all").arg(mark.face.title),
        [this, robot](const GroundPose& pose) { place(robot, pose); });
}

void PlaceRobot::place(const std::string& robot, const GroundPose& pose) {
    const double heading = pose.heading.value_or(headingOf(m_robots.mark(robot).baseInMap));
    const Pose baseInMap = poseFrom(pose.place, 0, 0, heading);
    const auto placed = m_context.station.mapping().place(robot, baseInMap);
    if (!placed) m_context.notify(QString::fromStdString(placed.error().text));
}

}  // namespace leitstand
