#pragma once

#include <optional>
#include <vector>

#include <QPointF>

#include "widgets/map_view/gestures/ground_pose.h"
#include "widgets/models/map/robot_mark.h"

class QPainter;

namespace leitstand {

class MapProjection;
struct OverlayStyle;

/// What an operator draws onto the floor: a robot's pose (press: place, drag: heading, as the 2D goal of
/// RViz), or the corners of an area.
class GroundTools {
public:
    /// Draws poses of @p robot from now on.
    void startPose(RobotMark robot);
    void startArea();  ///< draws an area from now on
    void startGrab();  ///< what is pressed on is dragged from now on
    void end();        ///< draws nothing any more
    [[nodiscard]] bool posing() const { return m_robot.has_value(); }
    [[nodiscard]] bool drawingArea() const { return m_drawingArea; }
    [[nodiscard]] bool grabbing() const { return m_grabbing; }

    /// A button went down over @p ground.
    void press(const Eigen::Vector3d& ground, const QPointF& pixel);
    void moveTo(const Eigen::Vector3d& ground, const QPointF& pixel);
    /// The pose that was drawn.
    [[nodiscard]] std::optional<GroundPose> release();

    /// Something is grabbed at @p ground; @p turns: to turn it.
    [[nodiscard]] GroundDrag grab(const Eigen::Vector3d& ground, bool turns);
    /// It was dragged to @p ground; empty: nothing is held.
    [[nodiscard]] std::optional<GroundDrag> dragTo(const Eigen::Vector3d& ground);
    void letGo() { m_held.reset(); }

    void addCorner(const Eigen::Vector3d& ground);
    void takeCornerBack();
    /// The area with at least three corners; drawing begins anew.
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

/// Where the ray under @p position meets the level plane at @p height [m]; nothing above the horizon or
/// farther than 200 m.
[[nodiscard]] std::optional<Eigen::Vector3d> groundUnder(const MapProjection& projection,
                                                         const QPointF& position, double height);

/// Outlines @p area (map frame) on the floor at @p height [m].
void paintArea(QPainter& painter, const MapProjection& projection, const std::vector<Eigen::Vector2d>& area,
               double height, const OverlayStyle& style);

}  // namespace leitstand
