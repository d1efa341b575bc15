#include <algorithm>
#include <utility>

#include <QHelpEvent>
#include <QMouseEvent>
#include <QRegularExpression>
#include <QStringList>
#include <QToolTip>

#include "widgets/map_view/map_view_state.h"
#include "widgets/models/map/robot_marks.h"

namespace leitstand {

void MapView::setRobots(std::vector<RobotMark> robots) {
    for (const RobotMark& robot : robots) {
        if (robot.selected) m_state->scenery.aim(robot.baseInMap);
    }
    const bool same =
        std::equal(robots.begin(), robots.end(), m_state->robots.begin(), m_state->robots.end(), sameMark);
    m_state->robots = std::move(robots);
    m_state->describe();
    if (same) return;
    std::vector<SceneRobot> team;
    for (const RobotMark& robot : m_state->robots)
        team.push_back({robot.face.name.toStdString(), robot.face.title.toStdString(), robot.face.place,
                        robot.face.letter.toStdString()});
    m_state->scenery.setTeam(std::move(team));
    update();
}

void MapView::setFinds(std::vector<VictimRow> finds, const std::optional<FindKey>& chosen) {
    if (finds == m_state->finds && chosen == m_state->chosenFind) return;
    m_state->finds = std::move(finds);
    m_state->chosenFind = chosen;
    update();
}

void MapView::setStale(bool stale) {
    if (std::exchange(m_state->stale, stale) != stale) update();
}

void MapView::setArea(std::vector<Eigen::Vector2d> area) {
    m_state->area = std::move(area);
    update();
}

void MapView::setGround(double height) {
    m_state->ground = height;
}

void MapView::setHint(const QString& text) {
    if (text == m_state->hint) return;
    m_state->hint = text;
    m_state->describe();
    update();
}

void MapView::setSeam(const std::optional<Measurement>& seam) {
    m_state->seam = seam;
    update();
}

void MapView::setCaptions(std::vector<MapCaption> captions) {
    m_state->captions = std::move(captions);
    update();
}

void MapView::setLinks(std::vector<MapLink> links) {
    if (links == m_state->links) return;
    m_state->links = std::move(links);
    update();
}

void MapView::State::describe() {
    QStringList lines = {hint, detailsOf(robots)};
    lines.removeAll(QString());
    const QString text = lines.join(QLatin1Char('\n'));
    // Percentages change all the time: screen readers are notified only when the words change.
    static const QRegularExpression figures(QStringLiteral("\\d[\\d.,]*"));
    const auto words = [](QString reported) { return reported.remove(figures); };
    if (words(text) != words(view.accessibleDescription())) view.setAccessibleDescription(text);
}

const RobotMark* MapView::State::robotAt(const QPointF& position) const {
    constexpr double Near = 24.0;  // of the robot's middle, from floor to top [pixels]
    for (const RobotMark& robot : robots) {
        const auto floor = view.project(robot.baseInMap.translation());
        const auto top = view.project(robot.baseInMap * Eigen::Vector3d(0, 0, robot.height));
        if (!floor || !top) continue;
        // Its letter stands above it.
        const QRectF about = QRectF(*floor, *top).normalized().adjusted(-Near, -2 * Near, Near, Near);
        if (about.contains(position)) return &robot;
    }
    return nullptr;
}

bool MapView::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto& help = static_cast<const QHelpEvent&>(*event);
    const RobotMark* const robot = m_state->robotAt(QPointF(help.pos()));
    QToolTip::showText(help.globalPos(), robot != nullptr ? robot->details : QString(), this);
    return true;
}

void MapView::startPose(const RobotMark& robot) {
    m_state->tools.startPose(robot);
    setCursor(Qt::CrossCursor);
}

void MapView::startArea() {
    m_state->tools.startArea();
    setCursor(Qt::CrossCursor);
}

void MapView::startGrab() {
    m_state->tools.startGrab();
    setCursor(Qt::SizeAllCursor);
}

void MapView::endGesture() {
    m_state->tools.end();
    setCursor(m_state->measuring ? Qt::CrossCursor : Qt::ArrowCursor);
    update();
}

bool MapView::drawing() const {
    return m_state->tools.posing() || m_state->tools.drawingArea() || m_state->tools.grabbing();
}

std::optional<Eigen::Vector3d> MapView::State::groundAt(const QPointF& position) const {
    const auto picked = view.pick(position.toPoint());
    if (picked && picked->label == Label::Floor) return picked->pointInMap;
    return groundUnder(scenery.projection(), position, ground);
}

bool MapView::State::pressGesture(const QMouseEvent& event) {
    if (!view.drawing()) return false;
    if (event.button() == Qt::RightButton) {
        if (tools.drawingArea()) {
            tools.takeCornerBack();
            view.update();
        } else {
            view.endGesture();
            emit view.gestureEnded();
        }
        return true;
    }
    if (event.button() != Qt::LeftButton) return false;  // the middle button still shifts the map
    if (tools.grabbing()) {
        const bool turns = event.modifiers().testFlag(Qt::ShiftModifier);
        if (const auto place = groundUnder(scenery.projection(), event.position(), ground))
            emit view.groundDragged(tools.grab(*place, turns));
        return true;
    }
    if (const auto place = groundAt(event.position())) {
        tools.press(*place, event.position());
        tools.addCorner(*place);
        view.update();
    }
    return true;
}

bool MapView::State::moveGesture(const QMouseEvent& event) {
    if (!view.drawing()) return false;
    if (tools.grabbing()) {
        const auto place = groundUnder(scenery.projection(), event.position(), ground);
        const auto drag = place ? tools.dragTo(*place) : std::nullopt;
        if (drag) emit view.groundDragged(*drag);
        return true;
    }
    // While a heading is drawn, the ground's plane counts: picked points would make it jump.
    if (const auto place = event.buttons().testFlag(Qt::LeftButton)
                               ? groundUnder(scenery.projection(), event.position(), ground)
                               : groundAt(event.position())) {
        tools.moveTo(*place, event.position());
        view.update();
    }
    return true;
}

bool MapView::State::releaseGesture(const QMouseEvent& event) {
    if (!view.drawing()) return false;
    if (event.button() != Qt::LeftButton) return true;
    tools.letGo();
    if (const auto pose = tools.release()) {
        drawn = true;  // the second press of a double click is no new gesture
        emit view.poseDrawn(*pose);
    }
    view.update();
    return true;
}

void MapView::mouseDoubleClickEvent(QMouseEvent* event) {
    State& state = *m_state;
    if (std::exchange(state.drawn, false)) return;
    if (event->button() != Qt::LeftButton || state.measuring || state.tools.posing() ||
        state.tools.grabbing()) {
        mousePressEvent(event);
        return;
    }
    if (state.tools.drawingArea()) {
        if (const auto area = state.tools.takeArea()) emit areaDrawn(*area);
        return;
    }
    if (const auto place = state.groundAt(event->position())) emit groundActivated(*place);
}

}  // namespace leitstand
