#pragma once

#include <optional>
#include <vector>

#include <QPointF>

#include "widgets/map_view/gestures/ground_pose.h"
#include "widgets/models/map/robots/robot_mark.h"

class QPainter;

namespace leitstand {

class MapProjection;
struct OverlayStyle;

/// Gestures on the floor. The operator draws a robot's pose (press for the place, drag for the heading, like
/// the 2D goal of RViz), draws the corners of an area, or drags something.
class GroundTools {
public:
    /// Starts drawing poses of @p robot.
    void startPose(RobotMark robot);
    void startArea();  ///< starts drawing an area
    void startGrab();  ///< starts dragging
    void end();        ///< ends the gesture
    [[nodiscard]] bool posing() const { return m_robot.has_value(); }
    [[nodiscard]] bool drawingArea() const { return m_drawingArea; }
    [[nodiscard]] bool grabbing() const { return m_grabbing; }

    /// A button was pressed over @p ground (map's frame [m]).
    void press(const Eigen::Vector3d& ground, const QPointF& pixel);
    void moveTo(const Eigen::Vector3d& ground, const QPointF& pixel);
    /// Returns the pose that was drawn; empty: none.
    [[nodiscard]] std::optional<GroundPose> release();

    /// Begins a drag at @p ground. @p turns: the drag turns instead of moving.
    [[nodiscard]] GroundDrag grab(const Eigen::Vector3d& ground, bool turns);
    /// Continues the drag to @p ground; empty: nothing is held.
    [[nodiscard]] std::optional<GroundDrag> dragTo(const Eigen::Vector3d& ground);
    void letGo() { m_held.reset(); }

    void addCorner(const Eigen::Vector3d& ground);
    void takeCornerBack();
    /// Returns the area in the map's frame [m] and begins a new one; empty: there are fewer than three
    /// corners.
    [[nodiscard]] std::optional<std::vector<Eigen::Vector2d>> takeArea();

    void paint(QPainter& painter, const MapProjection& projection, const OverlayStyle& style) const;

private:
    std::optional<RobotMark> m_robot;
    std::optional<GroundPose> m_pose;
    QPointF m_pressed;
    bool m_drawingArea = false;
    bool m_grabbing = false;
    std::optional<GroundDrag> m_held;
    std::vector<Eigen::Vector3d> m_corners;
    std::optional<Eigen::Vector3d> m_cursor;
};

/// Returns where the ray under @p position meets the horizontal plane at @p height [m]. Empty above the
/// horizon and, in a perspective view, farther than 200 m from the eye.
[[nodiscard]] std::optional<Eigen::Vector3d> groundUnder(const MapProjection& projection,
                                                         const QPointF& position, double height);

/// Outlines @p area (map frame) on the floor at @p height [m].
void paintArea(QPainter& painter, const MapProjection& projection, const std::vector<Eigen::Vector2d>& area,
               double height, const OverlayStyle& style);

}  // namespace leitstand
