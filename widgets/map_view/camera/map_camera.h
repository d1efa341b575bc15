#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include <QPointF>
#include <QPolygonF>
#include <QSize>

namespace leitstand {

/// From where the map is seen: a turntable around a focus, z up. A value.
struct MapCamera {
    static constexpr double FieldOfView = 0.7;  ///< vertical angle of view in perspective [rad]

    Eigen::Vector3d focus = Eigen::Vector3d::Zero();  ///< in the map's frame [m]
    double yaw = 0.0;        ///< heading of the view about z [rad]; 0: along x, positive: to the left
    double pitch = 0.5;      ///< downward angle of the view, between -pi/2 and pi/2 [rad]
    double distance = 10.0;  ///< from eye to focus [m]; in parallel projection it only sets the scale
    bool parallel = false;

    [[nodiscard]] Eigen::Vector3d forward() const;
    [[nodiscard]] Eigen::Vector3d right() const;
    [[nodiscard]] Eigen::Vector3d up() const;
    [[nodiscard]] Eigen::Vector3d eye() const;  ///< in the map's frame [m]

    bool operator==(const MapCamera&) const = default;
};

/// Where a point is drawn.
struct Projected {
    QPointF position;    ///< in the widget, logical pixels
    double depth = 0.0;  ///< in front of the eye, along the view [m]
};

/// The projection of a camera into a widget of a given size: from map to screen and back.
class MapProjection {
public:
    MapProjection(const MapCamera& camera, QSize size);

    /// Returns where @p pointInMap is drawn; empty when it is behind the eye.
    [[nodiscard]] std::optional<Projected> project(const Eigen::Vector3d& pointInMap) const;
    /// Returns the outline on the screen of a flat convex shape, without the part behind the eye; may be
    /// empty. @p corners: corners of the shape in order, in the map's frame [m].
    [[nodiscard]] QPolygonF outline(std::span<const Eigen::Vector3d> corners) const;
    /// Returns the point of the map under @p position at @p depth [m].
    [[nodiscard]] Eigen::Vector3d unproject(const QPointF& position, double depth) const;
    /// Returns the length that a logical pixel covers at @p depth [m].
    [[nodiscard]] double metresPerPixel(double depth) const;
    /// Returns the depth of the camera's focus [m].
    [[nodiscard]] double focusDepth() const;

    [[nodiscard]] const MapCamera& camera() const { return m_camera; }
    [[nodiscard]] QSize size() const { return m_size; }

    /// Points nearer to the eye are not drawn [m].
    static constexpr double NearestDepth = 0.02;

private:
    MapCamera m_camera;
    QSize m_size;
    Eigen::Vector3d m_eye, m_forward, m_right, m_up;
    double m_tangent;  ///< half the widget's height at a depth of 1
};

/// Returns @p camera moved, but not turned, so that all @p places (map's frame [m]) just fit into a widget of
/// @p size. The focus is then in the middle of the places.
[[nodiscard]] MapCamera framed(MapCamera camera, const std::vector<Eigen::Vector3d>& places, QSize size);

}  // namespace leitstand
