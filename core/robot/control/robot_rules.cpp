#include "core/robot/control/robot_rules.h"

#include <cmath>

#include "core/event/command_samples.h"
#include "core/event/station_samples.h"

namespace leitstand {

RobotRules::RobotRules(const std::string& robot, const RobotRuleSettings& settings)
    : m_settings(settings),
      m_grant(driveGrant(robot), settings.grants),
      m_latch(settings.firstStop),
      m_motion(settings.standing) {}

void RobotRules::receive(const GrantSample& sample, const Sender& from, SteadyTime now) {
    m_grant.receive(sample, from, now);
}

DriveVerdict RobotRules::obeyAnybody(const DriveVelocity& velocity) {
    if (m_latch.isStopped()) return DriveVerdict::Stopped;
    m_velocity = limited(velocity, m_settings.limits);
    return DriveVerdict::Taken;
}

DriveVerdict RobotRules::drive(const DriveVelocity& velocity, const Sender& from, SteadyTime now) {
    if (m_settings.careless) return obeyAnybody(velocity);
    if (!m_grant.obeys(from, now)) {
        // Commands and grants are two topics: its grant may still be on the way.
        if (isZero(velocity)) m_earlyZero = {from, now};
        return DriveVerdict::NotHolder;
    }
    const bool number =
        std::isfinite(velocity.forward) && std::isfinite(velocity.left) && std::isfinite(velocity.turn);
    const bool early =
        m_earlyZero && m_earlyZero->first == from && now - m_earlyZero->second < m_settings.early;
    // After so long without a command it stands. A new command may come from a stick held through a hang.
    if (now - m_driven >= m_settings.watchdog + SetpointForgotten) m_neutral = false;
    const bool neutral = early || (m_neutral && m_neutralIn == m_grant.changes());
    m_velocity = {};
    m_driver = from;
    m_driven = now;
    if (m_latch.isStopped()) return DriveVerdict::Stopped;
    if (!number) return DriveVerdict::NoNumber;
    if (!neutral && !isZero(velocity)) return DriveVerdict::NotNeutral;
    m_neutral = true;
    m_neutralIn = m_grant.changes();
    m_velocity = limited(velocity, m_settings.limits);
    return DriveVerdict::Taken;
}

StopStateSample RobotRules::receive(const StopCommandSample& command, const Sender& from, SteadyTime now) {
    const bool fromHolder = m_grant.obeys(from, now) && m_grant.holder(now) == command.station;
    static_cast<void>(m_latch.receive(command, from, fromHolder));
    if (m_latch.isStopped()) {
        m_neutral = false;
        m_earlyZero.reset();
        m_velocity = {};
    }
    return stopState(now);
}

void RobotRules::press() {
    m_latch.press();
    m_neutral = false;
    m_earlyZero.reset();
    m_velocity = {};
}

void RobotRules::moved(double speed, double turnRate, SteadyTime now) {
    m_motion.moved(speed, turnRate, now);
}

DriveVelocity RobotRules::commanded(SteadyTime now) const {
    if (m_settings.careless) return m_latch.isStopped() ? DriveVelocity{} : m_velocity;
    const bool valid = !m_latch.isStopped() && m_neutral && m_neutralIn == m_grant.changes() &&
                       m_grant.obeys(m_driver, now) && now - m_driven < m_settings.watchdog;
    return valid ? m_velocity : DriveVelocity{};
}

StopStateSample RobotRules::stopState(SteadyTime now) const {
    StopStateSample state = m_latch.state();
    state.standing = m_motion.isStanding(now);
    return state;
}

}  // namespace leitstand
