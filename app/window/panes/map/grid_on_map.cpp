#include "app/window/panes/map/grid_on_map.h"

#include <algorithm>
#include <optional>

#include <QAction>
#include <QKeySequence>

#include "app/window/commands/command_table.h"
#include "app/window/input/selection.h"
#include "app/window/source/moment_source.h"
#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/mapping/live/robot_in_map.h"
#include "core/station/robot_frames.h"
#include "widgets/map_view/map_view.h"
#include "widgets/models/map/robots/robot_grid.h"
#include "widgets/models/others_text.h"

namespace leitstand {
namespace {

const RobotInMap* placeOf(const LiveMoment& moment, const std::string& robot) {
    if (!moment.places) return nullptr;
    const auto found = std::find_if(moment.places->begin(), moment.places->end(),
                                    [&](const RobotInMap& one) { return one.robot == robot; });
    return found == moment.places->end() ? nullptr : &*found;
}

}  // namespace

GridOnMap::GridOnMap(const ViewContext& context, MapView& view, QObject* parent)
    : QObject(parent), m_context(context), m_view(view) {
    QAction& next = context.commands.add(
        {.id = "map.robotGrid",
         .menu = CommandMenu::Map,
         .text = tr("Next map of the &robot's own"),
         .hint = tr("Grid maps and costmaps of the selected robot over the map, one after the other, then "
                    "none"),
         .keys = QKeySequence(Qt::SHIFT | Qt::Key_Z)});
    connect(&next, &QAction::triggered, this, &GridOnMap::showNext);
    connect(&context.source, &MomentSource::ticked, this, &GridOnMap::show);
}

void GridOnMap::showNext() {
    const LiveMoment& moment = m_context.source.moment();
    const std::string name = m_context.selection.name().toStdString();
    const QString title = m_context.selection.face().title;
    const RobotState& robot = moment.reported(name);
    if (robot.grids.empty()) return m_context.source.notify(tr("%1 sends no map of its own").arg(title));
    std::string& topic = m_topics[name];
    topic = gridAfter(topic, robot);
    const QString shown = othersText(topic);
    if (topic.empty()) {
        m_context.source.notify(tr("%1: no map of its own is shown").arg(title));
    } else if (const RobotInMap* const place = placeOf(moment, name); place == nullptr || !place->placed) {
        m_context.source.notify(tr("%1: %2 is shown once the robot is in the map").arg(title, shown));
    } else if (const OccupancyGridSample& grid = robot.grids.at(topic)->sample; grid.cells.empty()) {
        m_context.source.notify(tr("%1: %2 is empty so far").arg(title, shown));
    } else if (!frameInMap(grid.header.frame, robot, *place)) {
        const QString odometry = robot.odometry ? othersText(robot.odometry->sample.header.frame) : QString();
        m_context.source.notify(tr("%1: %2 cannot be placed: no tf leads from \"%3\" to \"%4\"")
                                    .arg(title, shown, odometry, othersText(grid.header.frame)));
    } else {
        m_context.source.notify(tr("%1: %2 is shown over the map").arg(title, shown));
    }
    show(moment);
}

void GridOnMap::show(const LiveMoment& moment) {
    const std::string name = m_context.selection.name().toStdString();
    const auto topic = m_topics.find(name);
    std::optional<RobotGrid> grid;
    if (topic != m_topics.end() && !topic->second.empty()) {
        if (const RobotInMap* const place = placeOf(moment, name))
            grid = robotGridOf(topic->second, moment.reported(name), *place);
    }
    if (grid) {
        grid->robotPlace = m_context.selection.face().place;
        grid->title = m_context.selection.face().title + QStringLiteral(": ") + othersText(topic->second);
    }
    m_view.setGrid(std::move(grid));
}

}  // namespace leitstand
