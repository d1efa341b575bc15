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

/// Sends robots that take goals to places on the map: a pose drawn onto the floor, or a double click. Asks
/// for the grant first, since robots listen to its holder only.
class GoTo final : public QObject {
    Q_OBJECT
public:
    GoTo(const LiveContext& context, MapView& map, MapGestures& gestures, RobotsOnMap& robots,
         QObject* parent);

    /// Sends the selected robot there.
    void go(const GroundPose& pose);
    /// The selected robot is not sent any more where it was to go as soon as it may be driven.
    void takeBack();

private:
    /// A robot on its way.
    struct Way {
        Pose goalInMap;
        Time asked{};
        bool sent = false, began = false;
        Time moved{};  ///< last, as its odometry tells
    };
    void arm(bool on);
    void begin(const std::string& robot, const Pose& goalInMap);
    void follow(const LiveMoment& moment);
    /// Scans moved: goals move with those about them, or are withdrawn.
    void followMap(const LiveMapPtr& map);
    [[nodiscard]] bool underWay(const std::string& robot, const Way& way) const;
    void stay(const std::string& robot);  ///< where it is
    /// @p correction: how the map moved at its goal, to put before poses there.
    void withdraw(const std::string& robot, const Way& way, const Pose& correction);
    /// Where the robot is, by the newest scan and by odometry of one and the same moment; empty: nobody
    /// knows.
    [[nodiscard]] std::optional<RobotInMap> placeOf(const std::string& robot) const;
    [[nodiscard]] QString titleOf(const std::string& robot) const;  ///< as operators know it
    [[nodiscard]] bool send(const std::string& robot, const Way& way, const LiveMoment& moment);
    /// Whether nothing more is to be expected of @p way.
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
