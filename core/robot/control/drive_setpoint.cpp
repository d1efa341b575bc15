#include "core/robot/control/drive_setpoint.h"

#include <algorithm>
#include <cmath>

namespace leitstand {
namespace {

bool isFinite(const DriveVelocity& velocity) {
    return std::isfinite(velocity.forward) && std::isfinite(velocity.left) && std::isfinite(velocity.turn);
}

double usable(double limit) {
    return std::isfinite(limit) && limit > 0.0 ? limit : 0.0;
}

}  // namespace

DriveLimits limitsOf(const RobotDescription& robot) {
    return {robot.maxSpeed, robot.maxTurnRate, robot.drive == DriveType::Omnidirectional};
}

DriveVelocity limited(const DriveVelocity& velocity, const DriveLimits& limits) {
    if (!isFinite(velocity)) return {};
    DriveVelocity slow = velocity;
    if (!limits.sideways) slow.left = 0.0;
    const double most = usable(limits.speed), speed = std::hypot(slow.forward, slow.left);
    if (speed > most) {
        // The products of huge numbers would overflow: hypot may be infinite.
        const double scale = std::isfinite(speed) ? most / speed : 0.0;
        slow.forward *= scale;
        slow.left *= scale;
    }
    const double turn = usable(limits.turnRate);
    slow.turn = std::clamp(slow.turn, -turn, turn);
    return slow;
}

double trackDistance(const RobotDescription& robot) {
    if (robot.footprint.empty()) return 0.0;
    const auto [right, left] =
        std::minmax_element(robot.footprint.begin(), robot.footprint.end(),
                            [](const auto& one, const auto& other) { return one.y() < other.y(); });
    return left->y() - right->y();
}

std::pair<double, double> tracksOf(const DriveVelocity& velocity, double distance) {
    const double half = 0.5 * velocity.turn * distance;
    return {velocity.forward - half, velocity.forward + half};
}

DriveVelocity velocityOf(std::pair<double, double> tracks, double distance) {
    const auto [left, right] = tracks;
    return {0.5 * (left + right), 0.0, distance > 0.0 ? (right - left) / distance : 0.0};
}

DriveSetpoint::DriveSetpoint(const DriveLimits& limits, std::chrono::nanoseconds lifetime)
    : m_limits(limits), m_lifetime(lifetime) {}

void DriveSetpoint::set(const DriveVelocity& velocity, SteadyTime now, bool withoutEyes) {
    if (now - expires() >= SetpointForgotten) m_neutral = false;
    m_velocity = limited(velocity, m_limits);
    m_set = now;
    m_any = true;
    m_withoutEyes = withoutEyes;
    if (!isFinite(velocity)) {
        m_neutral = false;  // broken sticks are not neutral
    } else if (m_permitted && isZero(velocity)) {
        m_neutral = true;
    }
}

void DriveSetpoint::permit(bool permitted) {
    if (!permitted) m_neutral = false;
    m_permitted = permitted;
}

bool DriveSetpoint::isFresh(SteadyTime now) const {
    return m_permitted && m_any && now - m_set < m_lifetime;
}

DriveVelocity DriveSetpoint::at(SteadyTime now) const {
    return isFresh(now) && m_neutral ? m_velocity : DriveVelocity{};
}

}  // namespace leitstand
