#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QObject>
#include <QString>

#include "app/services/models/robot_bodies.h"
#include "app/window/panes/view_context.h"
#include "widgets/models/map/map_view_settings.h"
#include "widgets/models/map/robots/robot_drawings.h"
#include "widgets/models/map/robots/robot_mark.h"
#include "widgets/models/map/robots/robot_plans.h"

class QAction;

namespace leitstand {

class MapGestures;
class MapView;
class ViewState;
struct LiveMoment;

/// The robots on the live map, drawn at 30 Hz, and the camera that follows the selected robot.
class RobotsOnMap final : public QObject {
    Q_OBJECT
public:
    RobotsOnMap(const ViewContext& context, ViewState& state, MapView& view, MapGestures& gestures,
                QObject* parent);

    /// Returns the mark that was last drawn for @p robot. If the robot's place is unknown, the mark is at the
    /// place of another robot, or at the origin.
    [[nodiscard]] RobotMark mark(const std::string& robot) const;
    /// Returns a small square in the colours of @p robot, for something that is placed by hand.
    [[nodiscard]] RobotMark placeMark(const std::string& robot) const;
    [[nodiscard]] bool placed(const std::string& robot) const { return m_marks.contains(robot); }
    /// Returns a text that says how certain the robots' places in the map are, one line per robot.
    [[nodiscard]] const QString& details() const { return m_details; }
    /// Returns the robot that most needs to be placed: one that is not in the map yet, if possible the
    /// selected one. If all are in the map, returns the selected robot.
    [[nodiscard]] std::string toPlace() const;
    /// Sets the goal that is shown for @p robot, and where it goes @p next. Empty: none.
    void setGoal(const std::string& robot, const std::optional<Pose>& goalInMap,
                 const std::vector<Pose>& next = {});

private:
    void addCommands();
    void follow(MapFollow how);
    void show(const LiveMoment& moment);

    ViewContext m_context;
    ViewState& m_state;
    MapView& m_view;
    MapGestures& m_gestures;
    std::map<MapFollow, QAction*> m_follow;
    std::map<std::string, RobotMark> m_marks;  ///< marks of robots that are in the map
    /// Where a robot goes.
    struct Goals {
        Pose goalInMap;
        std::vector<Pose> next;
    };
    std::map<std::string, Goals> m_goals;
    std::map<std::string, RobotDrawer> m_drawers;
    QAction* m_drawn = nullptr;  ///< whether what robots draw is shown
    std::map<std::string, RobotPlans> m_plans;
    QString m_details;
    QAction* m_modelled = nullptr;  ///< whether robots are drawn by their models
    RobotBodies m_bodies;
};

}  // namespace leitstand
