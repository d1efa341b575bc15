#pragma once

#include <map>
#include <optional>
#include <string>

#include <QObject>

#include "app/window/panes/view_context.h"
#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/robot_in_map.h"
#include "widgets/map_view/gestures/ground_pose.h"

class QAction;

namespace leitstand {

class GoalQuestion;
class MapGestures;
class MapView;
class RobotsOnMap;
struct LiveMoment;

/// Sends robots that take goals to places on the map: a pose drawn onto the floor, or a double click.
/// Requests the grant first, since robots obey only its holder.
class GoTo final : public QObject {
    Q_OBJECT
public:
    GoTo(const LiveContext& context, MapView& map, MapGestures& gestures, RobotsOnMap& robots,
         QObject* parent);

    /// Sends the selected robot there.
    void go(const GroundPose& pose);
    /// Drops a goal of the selected robot that waits to be sent until the robot may be driven.
    void takeBack();

private:
    /// A robot on its way.
    struct Way {
        Pose goalInMap;
        Time asked{};
        bool sent = false, began = false;
        Time moved{};  ///< last motion in its odometry
    };
    void arm(bool on);
    void begin(const std::string& robot, const Pose& goalInMap);
    void follow(const LiveMoment& moment);
    /// Handles moved scans: goals move with the scans around them, or are withdrawn.
    void followMap(const LiveMapPtr& map);
    [[nodiscard]] bool underWay(const std::string& robot, const Way& way) const;
    void stay(const std::string& robot);  ///< sends it to where it is
    /// Withdraws the goal of @p way. @p correction: motion of the map at the goal, multiplied from the left
    /// to poses there.
    void withdraw(const std::string& robot, const Way& way, const Pose& correction);
    /// Returns where the robot is, by the newest scan and the odometry of the same moment. Empty when that is
    /// unknown.
    [[nodiscard]] std::optional<RobotInMap> placeOf(const std::string& robot) const;
    [[nodiscard]] QString titleOf(const std::string& robot) const;  ///< as operators know it
    [[nodiscard]] bool send(const std::string& robot, const Way& way, const LiveMoment& moment);
    /// Returns whether nothing more is to be expected of @p way.
    [[nodiscard]] bool over(const std::string& robot, Way& way, const LiveMoment& moment);
    void showSelected();

    LiveContext m_context;
    MapGestures& m_gestures;
    RobotsOnMap& m_robots;
    QAction* m_action;
    GoalQuestion* m_question;
    std::map<std::string, Way> m_ways;
    LiveMapPtr m_map;  ///< newest
};

}  // namespace leitstand
