#include "robots/simulation/sensors/pan_tilt.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/time.h"

namespace leitstand::simulation {
namespace {

double towards(double angle, double target, double most) {
    return angle + std::clamp(target - angle, -most, most);
}

}  // namespace

void PanTilt::setTarget(double pan, double tilt) {
    if (std::isfinite(pan)) m_target.pan = std::clamp(pan, -m_limits.pan, m_limits.pan);
    if (std::isfinite(tilt)) m_target.tilt = std::clamp(tilt, -m_limits.tiltUp, m_limits.tiltDown);
}

void PanTilt::advance(Time now) {
    if (now <= m_now) return;
    const double most = m_limits.speed * secondsBetween(m_now, now);
    m_before = m_now;
    m_anglesBefore = m_angles;
    m_now = now;
    m_angles.pan = towards(m_angles.pan, m_target.pan, most);
    m_angles.tilt = towards(m_angles.tilt, m_target.tilt, most);
}

PanTiltAngles PanTilt::at(Time time) const {
    if (m_now == m_before) return m_angles;
    const double share =
        std::clamp(secondsBetween(m_before, time) / secondsBetween(m_before, m_now), 0.0, 1.0);
    return {std::lerp(m_anglesBefore.pan, m_angles.pan, share),
            std::lerp(m_anglesBefore.tilt, m_angles.tilt, share)};
}

PanTiltAngles PanTilt::velocity() const {
    const double seconds = secondsBetween(m_before, m_now);
    if (!(seconds > 0.0)) return {};
    return {(m_angles.pan - m_anglesBefore.pan) / seconds, (m_angles.tilt - m_anglesBefore.tilt) / seconds};
}

Pose PanTilt::platform(Time time) const {
    const PanTiltAngles angles = at(time);
    return poseFrom(Eigen::Vector3d::Zero(), 0.0, angles.tilt, angles.pan);
}

}  // namespace leitstand::simulation
