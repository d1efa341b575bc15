#include "widgets/map_view/robots/follow_camera.h"

#include <algorithm>
#include <cmath>

#include "core/base/rotation/heading.h"
#include "widgets/models/map/robots/robot_mark.h"

namespace leitstand {
namespace {

constexpr double BehindPitch = degrees(28), BehindDistance = 4.5, AboveDistance = 9.0;
constexpr double Ahead = 0.18;  ///< share of the distance: more is seen ahead of the robot than behind it
constexpr double Up = 0.3;      ///< focus above the robot's base [m]
constexpr double Jump = 3.0;    ///< over longer distances the camera jumps [m]
/// Offsets at which it starts to move, and at which it has arrived [m], [rad].
constexpr double StartDistance = 0.01, StartAngle = degrees(0.4), EndDistance = 0.002,
                 EndAngle = degrees(0.05);

double angleBetween(double a, double b) {
    return std::remainder(b - a, degrees(360));
}

}  // namespace

void FollowCamera::start(MapFollow how, bool parallel) {
    const bool above = parallel || how == MapFollow::Above;
    m_parallel = parallel;
    m_yaw = 0.0;
    m_pitch = above ? degrees(90) : BehindPitch;
    m_distance = above ? AboveDistance : BehindDistance;
    m_aimed = m_moving = false;
}

MapCamera FollowCamera::wanted() const {
    MapCamera camera;
    camera.yaw = headingOf(m_robot) + m_yaw;
    camera.pitch = m_pitch;
    camera.distance = m_distance;
    camera.parallel = m_parallel;
    const Eigen::Vector3d ahead(std::cos(camera.yaw), std::sin(camera.yaw), 0.0);
    camera.focus = m_robot.translation() + Ahead * m_distance * ahead + Eigen::Vector3d(0, 0, Up);
    return camera;
}

bool FollowCamera::aim(const Pose& baseInMap, double seconds) {
    m_robot = baseInMap;
    const MapCamera target = wanted();
    const Eigen::Vector3d way = target.focus - m_camera.focus;
    if (!m_aimed || way.norm() > Jump) {
        m_camera = target;
        m_aimed = m_moving = true;
        return true;
    }
    const double turn = angleBetween(m_camera.yaw, target.yaw), tilt = target.pitch - m_camera.pitch;
    const double zoom = target.distance - m_camera.distance;
    const double step = std::max(way.norm(), std::abs(zoom)),
                 angle = std::max(std::abs(turn), std::abs(tilt));
    if (!m_moving && step < StartDistance && angle < StartAngle) return false;
    m_moving = step > EndDistance || angle > EndAngle;
    const double share = m_moving ? 1.0 - std::exp(-std::max(seconds, 0.0) / Lag) : 1.0;
    m_camera.focus += share * way;
    m_camera.yaw = std::remainder(m_camera.yaw + share * turn, degrees(360));
    m_camera.pitch += share * tilt;
    m_camera.distance += share * zoom;
    return true;
}

void FollowCamera::adjust(const MapCamera& camera) {
    m_yaw = std::remainder(m_yaw + angleBetween(m_camera.yaw, camera.yaw), degrees(360));
    m_pitch += camera.pitch - m_camera.pitch;
    m_distance *= camera.distance / m_camera.distance;
    m_pitch = std::clamp(m_pitch, degrees(-10), degrees(90));
    m_distance = std::clamp(m_distance, 1.0, 60.0);
    // Without lag: the operator moves it directly.
    const MapCamera target = wanted();
    m_camera.yaw = target.yaw;
    m_camera.pitch = target.pitch;
    m_camera.distance = target.distance;
    m_camera.focus = target.focus;
    m_moving = true;
}

}  // namespace leitstand
