#include "widgets/map_view/gestures/ground_tools.h"

#include <cmath>
#include <utility>

#include <QPainter>

#include "core/base/rotation/heading.h"
#include "widgets/map_view/camera/map_camera.h"
#include "widgets/map_view/overlays/overlay_style.h"
#include "widgets/map_view/robots/robot_overlay.h"

namespace leitstand {
namespace {

constexpr double LeastDrag = 8.0;       ///< shorter drags are clicks [px]
constexpr double LeastDistance = 0.05;  ///< between a drag's ends on the floor [m]
constexpr double Farthest = 200.0;      ///< from the eye [m]

std::optional<QPolygonF> outlineOf(const MapProjection& projection,
                                   const std::vector<Eigen::Vector3d>& corners) {
    QPolygonF outline;
    for (const Eigen::Vector3d& corner : corners) {
        const auto at = projection.project(corner);
        if (!at) return std::nullopt;
        outline << at->position;
    }
    return outline;
}

void strokeTwice(QPainter& painter, const QPolygonF& line, bool closed, const OverlayStyle& style) {
    const QColor colour = asColour(style.colours.measurement);
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen :
         {QPen(asColour(style.colours.background), 4.0), QPen(colour, 2.0, Qt::DashDotLine)}) {
        painter.setPen(pen);
        if (closed) {
            painter.drawPolygon(line);
        } else {
            painter.drawPolyline(line);
        }
    }
}

}  // namespace

void GroundTools::startPose(RobotMark robot) {
    end();
    m_robot = std::move(robot);
}

void GroundTools::startArea() {
    end();
    m_drawingArea = true;
}

void GroundTools::startGrab() {
    end();
    m_grabbing = true;
}

GroundDrag GroundTools::grab(const Eigen::Vector3d& ground, bool turns) {
    m_held = GroundDrag{ground, ground, turns, true};
    return *m_held;
}

std::optional<GroundDrag> GroundTools::dragTo(const Eigen::Vector3d& ground) {
    if (!m_held) return std::nullopt;
    m_held->to = ground;
    m_held->begins = false;
    return m_held;
}

void GroundTools::end() {
    *this = {};
}

void GroundTools::press(const Eigen::Vector3d& ground, const QPointF& pixel) {
    if (!m_robot) return;
    m_pose = GroundPose{ground, std::nullopt};
    m_pressed = pixel;
}

void GroundTools::moveTo(const Eigen::Vector3d& ground, const QPointF& pixel) {
    m_cursor = ground;
    if (!m_pose) return;
    const Eigen::Vector2d way = (ground - m_pose->place).head<2>();
    const bool dragged = (pixel - m_pressed).manhattanLength() >= LeastDrag && way.norm() >= LeastDistance;
    if (dragged) m_pose->heading = std::atan2(way.y(), way.x());
}

std::optional<GroundPose> GroundTools::release() {
    return std::exchange(m_pose, std::nullopt);
}

void GroundTools::addCorner(const Eigen::Vector3d& ground) {
    if (m_drawingArea) m_corners.push_back(ground);
}

void GroundTools::takeCornerBack() {
    if (!m_corners.empty()) m_corners.pop_back();
}

std::optional<std::vector<Eigen::Vector2d>> GroundTools::takeArea() {
    if (m_corners.size() < 3) return std::nullopt;
    std::vector<Eigen::Vector2d> area;
    for (const Eigen::Vector3d& corner : std::exchange(m_corners, {})) area.emplace_back(corner.head<2>());
    return area;
}

void GroundTools::paint(QPainter& painter, const MapProjection& projection, const OverlayStyle& style) const {
    if (m_robot && (m_pose || m_cursor)) {
        RobotMark ghost = *m_robot;
        const double standing = headingOf(ghost.baseInMap);
        const Eigen::Vector3d place = m_pose ? m_pose->place : *m_cursor;
        ghost.baseInMap = poseFrom(place, 0, 0, m_pose ? m_pose->heading.value_or(standing) : standing);
        ghost.trail = {};
        ghost.goalInMap.reset();
        ghost.note.clear();
        paintPlanned(painter, projection, ghost, style);
    }
    if (!m_drawingArea || m_corners.empty()) return;
    std::vector<Eigen::Vector3d> line = m_corners;
    if (m_cursor) line.push_back(*m_cursor);
    const auto outline = outlineOf(projection, line);
    if (!outline) return;
    strokeTwice(painter, *outline, false, style);
    painter.setBrush(asColour(style.colours.measurement));
    painter.setPen(QPen(asColour(style.colours.markerEdge), 1.0));
    for (const QPointF& corner : *outline) painter.drawEllipse(corner, 4, 4);
}

std::optional<Eigen::Vector3d> groundUnder(const MapProjection& projection, const QPointF& position,
                                           double height) {
    const MapCamera& camera = projection.camera();
    const double depth = projection.focusDepth();
    const Eigen::Vector3d on = projection.unproject(position, depth);
    const Eigen::Vector3d eye = projection.unproject(position, 0.0);  // parallel rays begin beside the eye
    const Eigen::Vector3d ray = on - eye;
    if (std::abs(ray.z()) < 1e-9) return std::nullopt;
    const double share = (height - eye.z()) / ray.z();
    if (share <= 0.0) return std::nullopt;
    const Eigen::Vector3d ground = eye + share * ray;
    if (!camera.parallel && (ground - eye).norm() > Farthest) return std::nullopt;
    return ground;
}

void paintArea(QPainter& painter, const MapProjection& projection, const std::vector<Eigen::Vector2d>& area,
               double height, const OverlayStyle& style) {
    if (area.size() < 3) return;
    std::vector<Eigen::Vector3d> corners;
    for (const Eigen::Vector2d& corner : area) corners.emplace_back(corner.x(), corner.y(), height);
    if (const auto outline = outlineOf(projection, corners)) strokeTwice(painter, *outline, true, style);
}

}  // namespace leitstand
