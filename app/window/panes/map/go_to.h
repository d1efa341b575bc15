#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

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

/// Sends robots to places on the map: a pose that the operator draws on the floor, or a double click. Also to
/// several places, one after the other, or back to where their trail begins. For robots that take goals.
/// Requests the grant first, since robots obey only its holder.
class GoTo final : public QObject {
    Q_OBJECT
public:
    GoTo(const LiveContext& context, MapView& map, MapGestures& gestures, RobotsOnMap& robots,
         QObject* parent);

    /// Sends the selected robot to @p pose. If the pose has no heading, it gets the direction from the robot
    /// to it.
    void go(const GroundPose& pose);
    /// Adds @p pose to where the selected robot goes after its goal; without a goal, as go().
    void goNext(const GroundPose& pose);
    /// Sends the selected robot to where its trail in the map begins.
    void returnToStart();
    /// Discards the selected robot's goal if it still waits until the robot may be driven, or cancels it if
    /// the robot's navigation follows it. Also ends a question about the goal.
    void takeBack();

private:
    /// A robot on its way.
    struct Way {
        Pose goalInMap;
        Time asked{};
        bool sent = false, began = false;
        bool followed = false;     ///< whether the robot's navigation reports what becomes of it
        Time moved{};              ///< stamp of the last odometry that showed motion
        std::vector<Pose> next{};  ///< where it goes after that, in the map
    };
    /// Whether a way has ended, and how.
    enum class Ending { No, Arrived, Otherwise };
    void arm(QAction& action, bool on, const QString& hint, void (GoTo::*then)(const GroundPose&));
    /// Returns @p pose with a heading: its own, or that of the way from @p from.
    [[nodiscard]] static Pose headed(const GroundPose& pose, const Eigen::Vector3d& from);
    /// Whether the selected robot can be sent; notifies the operator why not.
    [[nodiscard]] bool maySend() const;
    /// Shows goal and further places of @p robot's way; nothing when it has none.
    void showWay(const std::string& robot);
    /// Whether something speaks against sending @p robot on by itself: a stop, a driver's sticks, another
    /// station's drive control.
    [[nodiscard]] static bool isHeldBack(const std::string& robot, const LiveMoment& moment);
    /// Gives up where @p robot was to go next, and tells the operator unless everybody knows why.
    void dropNext(const std::string& robot, Way& way);
    /// Goes on to the next place of the way of @p robot, which has ended so. Returns false when there is
    /// none.
    [[nodiscard]] bool goOn(const std::string& robot, Way& way, Ending ending);
    void begin(const std::string& robot, const Pose& goalInMap);
    void follow(const LiveMoment& moment);
    /// Call after scans moved: goals move with the scans around them, or are withdrawn.
    void followMap(const LiveMapPtr& map);
    [[nodiscard]] bool underWay(const std::string& robot, const Way& way) const;
    void stay(const std::string& robot);  ///< stops the robot: its present place becomes its goal
    /// Withdraws the goal of @p way. @p correction: how the map moved at the goal (new pose = @p correction *
    /// old pose, both in the map).
    void withdraw(const std::string& robot, const Way& way, const Pose& correction);
    /// Returns the robot in the map, with the pose of its odometry frame at the same time. Empty: either is
    /// unknown.
    [[nodiscard]] std::optional<RobotInMap> placeOf(const std::string& robot) const;
    [[nodiscard]] QString titleOf(const std::string& robot) const;  ///< name for the operator
    [[nodiscard]] bool send(const std::string& robot, const Way& way, const LiveMoment& moment);
    /// Sends the goal when the station holds the grant. Returns whether @p way has ended: reached, or given
    /// up, stopped, never sent.
    [[nodiscard]] Ending over(const std::string& robot, Way& way, const LiveMoment& moment);
    /// over() for a goal that the robot's navigation follows.
    [[nodiscard]] Ending endOf(const std::string& robot, const LiveMoment& moment);
    void showSelected();

    LiveContext m_context;
    MapGestures& m_gestures;
    RobotsOnMap& m_robots;
    QAction *m_action, *m_nextAction, *m_returnAction;
    GoalQuestion* m_question;
    std::map<std::string, Way> m_ways;
    LiveMapPtr m_map;  ///< newest map
};

}  // namespace leitstand
