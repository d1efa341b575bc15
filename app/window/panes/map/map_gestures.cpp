#include "app/window/panes/map/map_gestures.h"

#include <utility>

#include <QAction>

#include "widgets/map_view/map_view.h"
#include "widgets/models/map/robots/robot_mark.h"

namespace leitstand {

MapGestures::MapGestures(MapView& view, QObject* parent) : QObject(parent), m_view(view) {
    connect(&view, &MapView::poseDrawn, this, [this](const GroundPose& pose) {
        const auto then = std::exchange(m_thenPose, {});
        disarm();
        if (then) then(pose);
    });
    connect(&view, &MapView::areaDrawn, this, [this](const std::vector<Eigen::Vector2d>& area) {
        const auto then = std::exchange(m_thenArea, {});
        disarm();
        if (then) then(area);
    });
    connect(&view, &MapView::groundDragged, this, [this](const GroundDrag& drag) {
        if (m_thenDrag) m_thenDrag(drag);
    });
    connect(&view, &MapView::gestureEnded, this, &MapGestures::disarm);
}

void MapGestures::arm(QAction& by, const QString& hint) {
    disarm();
    m_by = &by;
    by.setChecked(true);
    m_view.setHint(hint);
}

void MapGestures::armPose(QAction& by, const RobotMark& robot, const QString& hint,
                          std::function<void(const GroundPose&)> then) {
    arm(by, hint);
    m_thenPose = std::move(then);
    m_view.startPose(robot);
}

void MapGestures::armArea(QAction& by, const QString& hint,
                          std::function<void(const std::vector<Eigen::Vector2d>&)> then) {
    arm(by, hint);
    m_thenArea = std::move(then);
    m_view.startArea();
}

void MapGestures::armGrab(QAction& by, const QString& hint, std::function<void(const GroundDrag&)> then) {
    arm(by, hint);
    m_thenDrag = std::move(then);
    m_view.startGrab();
}

void MapGestures::disarm() {
    m_thenDrag = {};
    m_thenPose = {};
    m_thenArea = {};
    m_view.endGesture();
    m_view.setHint(m_calmHint);
    if (QAction* const by = m_by) by->setChecked(false);
    m_by.clear();
}

void MapGestures::setCalmHint(const QString& text) {
    m_calmHint = text;
    if (!armed()) m_view.setHint(text);
}

}  // namespace leitstand
