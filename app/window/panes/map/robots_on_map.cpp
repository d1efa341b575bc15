#include "app/window/panes/map/robots_on_map.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <QAction>
#include <QActionGroup>
#include <QKeySequence>

#include "app/window/commands/command_table.h"
#include "app/window/input/selection.h"
#include "app/window/map/view_state.h"
#include "app/window/panes/map/map_gestures.h"
#include "app/window/source/moment_source.h"
#include "widgets/map_view/map_view.h"
#include "widgets/models/live/texts/goal_text.h"
#include "widgets/models/map/robots/robot_marks.h"

namespace leitstand {
namespace {

MapFollow after(MapFollow how) {
    switch (how) {
        case MapFollow::Free:
            return MapFollow::Behind;
        case MapFollow::Behind:
            return MapFollow::Above;
        case MapFollow::Above:
            break;
    }
    return MapFollow::Free;
}

}  // namespace

RobotsOnMap::RobotsOnMap(const ViewContext& context, ViewState& state, MapView& view, MapGestures& gestures,
                         QObject* parent)
    : QObject(parent),
      m_context(context),
      m_state(state),
      m_view(view),
      m_gestures(gestures),
      m_bodies([this](const std::string& text) {
          QMetaObject::invokeMethod(
              this, [this, text] { m_context.notify(QString::fromStdString(text)); }, Qt::QueuedConnection);
      }) {
    addCommands();
    connect(&view, &MapView::followEnded, this, [this] { follow(MapFollow::Free); });
    connect(&context.source, &MomentSource::ticked, this, &RobotsOnMap::show);
}

void RobotsOnMap::addCommands() {
    CommandTable& commands = m_context.commands;
    commands.separate(CommandMenu::Map);
    QAction& next = commands.add(
        {.id = "map.follow",
         .menu = CommandMenu::Map,
         .text = tr("Next way to &follow"),
         .hint = tr("The map stands still, follows the selected robot from behind, or from above"),
         .keys = QKeySequence(Qt::Key_Z)});
    connect(&next, &QAction::triggered, this, [this] { follow(after(m_state.settings().follow)); });
    const auto add = [&](MapFollow how, const QString& id, const QString& text, const QString& hint) {
        QAction& one =
            commands.add({.id = id, .menu = CommandMenu::Map, .text = text, .hint = hint, .checkable = true});
        connect(&one, &QAction::triggered, this, [this, how] { follow(how); });
        m_follow[how] = &one;
    };
    add(MapFollow::Free, "map.free", tr("Map stands &still"), tr("The mouse alone moves the map"));
    add(MapFollow::Behind, "map.followBehind", tr("Follow from be&hind"),
        tr("The camera stays behind and above the selected robot; ceilings are hidden"));
    add(MapFollow::Above, "map.followAbove", tr("Follow from a&bove"),
        tr("The camera stays above the selected robot, its heading up; ceilings are hidden"));
    m_drawn =
        &commands.add({.id = "map.drawings",
                       .menu = CommandMenu::Map,
                       .text = tr("What robots &draw"),
                       .hint = tr("Markers, outlines, detections and places that robots publish, over the "
                                  "map"),
                       .keys = QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_D),
                       .checkable = true});
    m_drawn->setChecked(true);
    m_modelled =
        &commands.add({.id = "map.models",
                       .menu = CommandMenu::Map,
                       .text = tr("Robots as their &models"),
                       .hint = tr("Robots that publish their model (robot_description) are drawn by it, "
                                  "with their joints; others as symbols"),
                       .checkable = true});
    m_modelled->setChecked(true);
    const auto check = [this] {
        for (const auto& [how, action] : m_follow) action->setChecked(how == m_state.settings().follow);
    };
    connect(&m_state, &ViewState::changed, this, check);
    check();
}

void RobotsOnMap::follow(MapFollow how) {
    m_state.alter([how](MapViewSettings& settings) { settings.follow = how; });
    for (const auto& [one, action] : m_follow) action->setChecked(one == how);
}

RobotMark RobotsOnMap::mark(const std::string& robot) const {
    if (const auto found = m_marks.find(robot); found != m_marks.end()) return found->second;
    RobotMark mark;
    const RobotDescription* const known = m_context.selection.find(QString::fromStdString(robot));
    if (known == nullptr) return mark;
    RobotInMap place;
    place.placed = place.certain = true;
    place.robot = robot;
    if (!m_marks.empty()) place.baseInMap = m_marks.begin()->second.baseInMap;
    return *robotMarkOf(m_context.selection.faceOfRobot(*known), *known, place, {}, false);
}

RobotMark RobotsOnMap::placeMark(const std::string& robot) const {
    RobotMark square = mark(robot);
    square.footprint = {{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}};
    square.height = 0.2;
    return square;
}

std::string RobotsOnMap::toPlace() const {
    std::string selected = m_context.selection.name().toStdString();
    if (!placed(selected)) return selected;
    for (const RobotDescription& robot : m_context.selection.robots()) {
        if (!placed(robot.name)) return robot.name;
    }
    return selected;
}

void RobotsOnMap::setGoal(const std::string& robot, const std::optional<Pose>& goalInMap,
                          const std::vector<Pose>& next) {
    m_goals.erase(robot);
    if (goalInMap) m_goals.emplace(robot, Goals{*goalInMap, next});
}

void RobotsOnMap::show(const LiveMoment& moment) {
    const RobotsInMapPtr places = moment.places;
    const std::string selected = m_context.selection.name().toStdString();
    m_marks.clear();
    std::vector<RobotMark> marks;
    std::vector<RobotFace> unplaced;
    for (const RobotDescription& robot : m_context.selection.robots()) {
        const RobotFace face = m_context.selection.faceOfRobot(robot);
        const auto place = std::find_if(places->begin(), places->end(),
                                        [&robot](const RobotInMap& one) { return one.robot == robot.name; });
        if (place == places->end()) continue;
        const auto goal = m_goals.find(robot.name);
        auto mark = robotMarkOf(face, robot, *place, moment.view(robot.name).link, robot.name == selected,
                                goal == m_goals.end() ? std::nullopt : std::optional(goal->second.goalInMap));
        if (!mark) {
            unplaced.push_back(face);
            continue;
        }
        if (m_modelled->isChecked())
            setBody(*mark, m_bodies.body(robot, moment.reported(robot.name).model), moment.view(robot.name));
        if (goal != m_goals.end()) mark->waypoints = goal->second.next;
        if (goal != m_goals.end() && mark->note.isEmpty())
            mark->note = goalNote(moment.view(robot.name).navigation);
        if (m_drawn->isChecked())
            mark->drawings = m_drawers[robot.name].at(robot, moment.reported(robot.name), *place, moment.now);
        mark->plans = m_plans[robot.name].at(moment.reported(robot.name), *place, moment.now);
        m_marks.emplace(robot.name, *mark);
        marks.push_back(*mark);
    }
    const QAction* const placing = m_context.commands.find(QStringLiteral("map.placeRobot"));
    // Before the first scan there is no map to be placed in.
    m_gestures.setCalmHint(
        marks.empty() ? QString()
                      : unplacedText(unplaced, placing == nullptr
                                                   ? QString()
                                                   : placing->shortcut().toString(QKeySequence::NativeText)));
    if (!marks.empty()) m_view.setGround(mark(selected).baseInMap.translation().z());
    m_details = detailsOf(marks);
    m_view.setRobots(std::move(marks));
}

}  // namespace leitstand
