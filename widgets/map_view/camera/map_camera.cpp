#include "widgets/map_view/camera/map_camera.h"

#include <algorithm>
#include <cmath>

namespace leitstand {
namespace {

constexpr double ParallelEyeDistance = 500.0;  ///< puts everything in front of the eye of a parallel view [m]
constexpr double FrameMargin = 1.06;           ///< room left around what is framed
constexpr double OverlayHeight = 44.0;         ///< of legend and scale at the lower edge [px]
constexpr double PlaceRadius = 0.3;            ///< a place stands for its surroundings, voxels too [m]
constexpr double NearestFrame = 1.5;           ///< a camera never frames from nearer than this [m]

/// The part of a view that framing may fill, as tangents of the angles from its middle.
struct Frame {
    double right, above, below;

    explicit Frame(QSize size) {
        const double height = std::max(size.height(), 1), width = std::max(size.width(), 1);
        const double tangent = std::tan(MapCamera::FieldOfView / 2) / FrameMargin;
        const double overlays = std::min(2.0 * OverlayHeight / height, 0.4);
        right = tangent * width / height;
        above = tangent;
        below = tangent * (1.0 - overlays);
    }
};

/// The range of all places in (right, up) over depth, and how far the eye must move back until all of them
/// fit [m].
struct Fit {
    Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9), high = Eigen::Vector2d::Constant(-1e9);
    double back = -1e9;
};

Fit fit(const MapCamera& camera, const std::vector<Eigen::Vector3d>& places, const Frame& frame) {
    const Eigen::Vector3d right = camera.right(), up = camera.up(), forward = camera.forward();
    Fit result;
    for (const Eigen::Vector3d& place : places) {
        const Eigen::Vector3d offset = place - camera.focus;
        const Eigen::Vector2d across(offset.dot(right), offset.dot(up));
        const double ahead = camera.parallel ? 0.0 : offset.dot(forward);
        const double needed =
            std::max({(std::abs(across.x()) + PlaceRadius) / frame.right,
                      (across.y() + PlaceRadius) / frame.above, (PlaceRadius - across.y()) / frame.below});
        result.back = std::max(result.back, needed - ahead + PlaceRadius - camera.distance);
        const Eigen::Vector2d seen = across / std::max(camera.distance + ahead, 0.1);
        result.low = result.low.cwiseMin(seen);
        result.high = result.high.cwiseMax(seen);
    }
    return result;
}

}  // namespace

Eigen::Vector3d MapCamera::forward() const {
    return {std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), -std::sin(pitch)};
}

Eigen::Vector3d MapCamera::right() const {
    return {std::sin(yaw), -std::cos(yaw), 0.0};
}

Eigen::Vector3d MapCamera::up() const {
    return {std::sin(pitch) * std::cos(yaw), std::sin(pitch) * std::sin(yaw), std::cos(pitch)};
}

Eigen::Vector3d MapCamera::eye() const {
    return focus - (parallel ? distance + ParallelEyeDistance : distance) * forward();
}

MapProjection::MapProjection(const MapCamera& camera, QSize size)
    : m_camera(camera),
      m_size(size.expandedTo(QSize(1, 1))),
      m_eye(camera.eye()),
      m_forward(camera.forward()),
      m_right(camera.right()),
      m_up(camera.up()),
      m_tangent(std::tan(MapCamera::FieldOfView / 2)) {}

std::optional<Projected> MapProjection::project(const Eigen::Vector3d& pointInMap) const {
    const Eigen::Vector3d offset = pointInMap - m_eye;
    const double depth = offset.dot(m_forward);
    if (depth < NearestDepth) return std::nullopt;
    const double scale = 1.0 / metresPerPixel(depth);
    return Projected{{m_size.width() / 2.0 + scale * offset.dot(m_right),
                      m_size.height() / 2.0 - scale * offset.dot(m_up)},
                     depth};
}

QPolygonF MapProjection::outline(std::span<const Eigen::Vector3d> corners) const {
    constexpr double Nearest = 0.1;  // nearer parts would reach far beyond any screen [m]
    const auto depthOf = [this](const Eigen::Vector3d& corner) { return (corner - m_eye).dot(m_forward); };
    QPolygonF seen;
    const auto add = [&](const Eigen::Vector3d& corner) {
        if (const auto projected = project(corner)) seen << projected->position;
    };
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Eigen::Vector3d &from = corners[i], &to = corners[(i + 1) % corners.size()];
        const double before = depthOf(from), after = depthOf(to);
        if (before >= Nearest) add(from);
        if ((before >= Nearest) != (after >= Nearest))
            add(from + (Nearest - before) / (after - before) * (to - from));
    }
    return seen;
}

Eigen::Vector3d MapProjection::unproject(const QPointF& position, double depth) const {
    const double scale = metresPerPixel(depth);
    return m_eye + depth * m_forward + scale * (position.x() - m_size.width() / 2.0) * m_right -
           scale * (position.y() - m_size.height() / 2.0) * m_up;
}

double MapProjection::metresPerPixel(double depth) const {
    return 2.0 * m_tangent * (m_camera.parallel ? m_camera.distance : depth) / m_size.height();
}

double MapProjection::focusDepth() const {
    return (m_camera.focus - m_eye).dot(m_forward);
}

MapCamera framed(MapCamera camera, const std::vector<Eigen::Vector3d>& places, QSize size) {
    if (places.empty()) return camera;
    const Frame frame(size);
    const Eigen::Vector2d aim(0.0, (frame.above - frame.below) / 2);
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& place : places) box.extend(place);
    camera.focus = box.center();
    camera.distance = box.diagonal().norm();
    // Perspective enlarges what is near: adapt the distance and centre the view, a few times.
    for (int round = 0; round < 8; ++round) {
        camera.distance = std::max(camera.distance + fit(camera, places, frame).back, NearestFrame);
        const Fit now = fit(camera, places, frame);
        const Eigen::Vector2d step = camera.distance * ((now.low + now.high) / 2.0 - aim);
        camera.focus += step.x() * camera.right() + step.y() * camera.up();
    }
    camera.distance = std::max(camera.distance + fit(camera, places, frame).back, NearestFrame);
    return camera;
}

}  // namespace leitstand
