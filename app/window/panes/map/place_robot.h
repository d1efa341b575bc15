#pragma once

#include <string>

#include <QObject>

#include "app/window/panes/view_context.h"
#include "widgets/map_view/gestures/ground_pose.h"

class QAction;

namespace leitstand {

class MapGestures;
class RobotsOnMap;

/// Places a robot where the operator draws it on the map: a robot that is not in the map yet, otherwise the
/// selected one. A second command looks for the selected robot in the whole map.
class PlaceRobot final : public QObject {
    Q_OBJECT
public:
    PlaceRobot(const LiveContext& context, MapGestures& gestures, RobotsOnMap& robots, QObject* parent);

private:
    void arm(bool on);
    void lookFor();
    void place(const std::string& robot, const GroundPose& pose);

    LiveContext m_context;
    MapGestures& m_gestures;
    RobotsOnMap& m_robots;
    QAction* m_action;
};

}  // namespace leitstand
