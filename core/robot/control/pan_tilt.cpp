#include "core/robot/control/pan_tilt.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/pose.h"

namespace leitstand {
namespace {

using namespace std::chrono_literals;

constexpr auto LeastGap = 40ms;    ///< between two commands
constexpr auto RepeatGap = 500ms;  ///< of the same command
constexpr auto Patience = 5s;
constexpr auto LongestStep = 100ms;       ///< longest step of a rate: after a pause it does not jump
constexpr double Reached = degrees(0.5);  ///< [rad]
constexpr PanTiltAngles Still = {};

double cut(double angle, double least, double most) {
    return std::isfinite(angle) ? std::clamp(angle, least, most) : 0.0;
}

bool near(const PanTiltAngles& a, const PanTiltAngles& b) {
    return std::abs(a.pan - b.pan) < Reached && std::abs(a.tilt - b.tilt) < Reached;
}

/// Converts a direction of the optical frame to the frame with x ahead, y left, z up.
Eigen::Vector3d upright(const Eigen::Vector3d& optical) {
    return {optical.z(), -optical.x(), -optical.y()};
}

Eigen::Vector3d tilted(const Eigen::Vector3d& v, double tilt) {
    return {std::cos(tilt) * v.x() + std::sin(tilt) * v.z(), v.y(),
            std::cos(tilt) * v.z() - std::sin(tilt) * v.x()};
}

double yawOf(const Eigen::Vector3d& v) {
    return std::atan2(v.y(), v.x());
}

}  // namespace

PanTiltAngles within(const PanTiltMount& mount, const PanTiltAngles& angles) {
    return {cut(angles.pan, -mount.pan, mount.pan), cut(angles.tilt, -mount.up, mount.down)};
}

PanTiltAngles towards(const Eigen::Vector3d& direction) {
    return {yawOf(direction), -std::atan2(direction.z(), direction.head<2>().norm())};
}

PanTiltAngles dragged(const PanTiltAngles& start, const Eigen::Vector3d& grabbed,
                      const Eigen::Vector3d& pointer) {
    const Eigen::Vector3d thing = tilted(upright(grabbed.normalized()), start.tilt);  // without the pan
    const Eigen::Vector3d seen = upright(pointer.normalized());
    // First the tilt that brings the pointer's direction to the height of the target, then the pan.
    const double reach = std::hypot(seen.x(), seen.z());
    if (!(reach > 1e-6) || !thing.allFinite()) return start;
    const double height = std::clamp(thing.z() / reach, -1.0, 1.0);
    const double tilt = std::atan2(seen.z(), seen.x()) - std::asin(height);
    const double pan = start.pan + yawOf(thing) - yawOf(tilted(seen, tilt));
    return {pan, tilt};
}

void PanTiltControl::want(const PanTiltAngles& angles, SteadyTime now) {
    const PanTiltAngles wanted = within(m_mount, angles);
    if (m_requested != wanted) m_changed = now;
    m_requested = wanted;
}

void PanTiltControl::turnTo(const PanTiltAngles& angles, SteadyTime now) {
    m_rate = {};
    m_changed = now;  // a repeated wish is tried again
    m_sent.reset();
    want(angles, now);
}

void PanTiltControl::turnBy(const PanTiltAngles& step, SteadyTime now) {
    const PanTiltAngles from = base();
    turnTo({from.pan + step.pan, from.tilt + step.tilt}, now);
}

void PanTiltControl::setRate(const PanTiltAngles& perSecond, SteadyTime now) {
    moveOn(now);
    const bool stops = m_rate != Still && perSecond == Still;
    m_rate = perSecond;
    m_movedTo = now;
    if (stops) want(base(), now);
}

void PanTiltControl::moveOn(SteadyTime now) {
    if (m_rate == Still) return;
    const double seconds =
        std::chrono::duration<double>(std::clamp<SteadyTime::duration>(now - m_movedTo, 0ms, LongestStep))
            .count();
    m_movedTo = now;
    const PanTiltAngles from = base();
    want({from.pan + seconds * m_rate.pan, from.tilt + seconds * m_rate.tilt}, now);
}

std::optional<PanTiltAngles> PanTiltControl::due(SteadyTime now) {
    moveOn(now);
    if (!m_requested) return std::nullopt;
    const bool there = m_now && near(*m_now, *m_requested) && m_sent == m_requested;
    if (m_rate == Still && (there || now - m_changed > Patience)) {
        m_requested.reset();
        m_sent.reset();
        return std::nullopt;
    }
    const auto gap = now - m_sentAt;
    if (m_sent && (gap < LeastGap || (m_sent == m_requested && gap < RepeatGap))) return std::nullopt;
    m_sent = m_requested;
    m_sentAt = now;
    return m_requested;
}

}  // namespace leitstand
