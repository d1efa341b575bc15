#include "core/robot/control/stop/stop_control.h"

#include <algorithm>
#include <utility>

#include "core/base/words.h"

namespace leitstand {

StopControl::StopControl(std::string station, bool supported, const StopTiming& timing)
    : m_station(std::move(station)), m_supported(supported), m_timing(timing), m_motion(timing.standing) {}

void StopControl::send(bool stop, SteadyTime now, Time wall) {
    const auto clock = wall.time_since_epoch().count();
    m_number = std::max(m_number + 1, clock > 0 ? static_cast<std::uint64_t>(clock) : 1U);
    m_pending = StopCommandSample{wall, m_station, m_number, stop, stop || !m_state ? 0U : m_state->stops};
    m_since = m_next = now;
}

void StopControl::stop(SteadyTime now, Time wall) {
    m_refused.clear();
    m_wanted = true;
    m_acknowledged = false;
    if (m_supported) send(true, now, wall);
}

Result<void> StopControl::release(bool held, SteadyTime now, Time wall) {
    if (!held)
        return Error{translate("leitstand::Error", "release: this station does not hold the grant to drive")};
    m_refused.clear();
    if (!m_supported) {
        m_wanted = false;
        return {};
    }
    if (!m_state)
        return Error{translate("leitstand::Error", "release: the robot has not reported its stop yet")};
    if (m_pending && m_pending->stop)
        return Error{translate("leitstand::Error", "release: the robot has not acknowledged the stop yet")};
    if (!m_pending) send(false, now, wall);
    return {};
}

void StopControl::answered(const StopStateSample& state) {
    const bool stop = m_pending->stop;
    m_pending.reset();
    if (stop) {
        m_acknowledged = true;
    } else if (state.refused.empty()) {
        m_wanted = m_acknowledged = false;
    } else {
        m_refused = state.refused;
    }
}

void StopControl::receive(const StopStateSample& state) {
    m_state = state;
    if (m_pending && state.station == m_station && state.number == m_pending->number) return answered(state);
    if (m_pending && !m_pending->stop && state.stopped && state.stops != m_pending->releases) {
        m_pending.reset();  // the robot will refuse it if it still arrives
        m_refused = "the robot was stopped again since";
    }
    // A stop without acknowledgement stays in force: the robot reports an older one.
    if (m_wanted && m_acknowledged && !state.stopped) m_wanted = m_acknowledged = false;
}

void StopControl::moved(double speed, double turnRate, SteadyTime now) {
    m_motion.moved(speed, turnRate, now);
}

std::optional<StopCommandSample> StopControl::due(SteadyTime now, Time wall) {
    if (!m_pending) return std::nullopt;
    if (!m_pending->stop && now - m_since >= m_timing.release) {
        stop(now, wall);
        m_refused = "the robot did not answer the release: stopped again";
    }
    if (now < m_next) return std::nullopt;
    m_next = now + m_timing.repeat;
    return m_pending;
}

StopStatus StopControl::status(SteadyTime now) const {
    StopStatus status;
    status.supported = m_supported;
    status.sent = m_wanted;
    status.acknowledged = m_wanted && m_acknowledged;
    status.releasing = m_pending && !m_pending->stop;
    status.refused = m_refused;
    if (m_pending) status.unanswered = now - m_since;
    if (m_state) {
        status.stopped = m_state->stopped;
        status.stoppedBy = m_state->station;
    }
    // Odometry decides where it is available: it is newer than the robot's report on change.
    const bool odometry = m_motion.isKnown(now);
    status.standingKnown = odometry || m_state.has_value();
    status.standing = odometry ? m_motion.isStanding(now) : m_state && m_state->standing;
    return status;
}

bool StopControl::allowsDriving() const {
    const bool stopped = m_state && m_state->stopped;
    return !m_wanted && !stopped && !m_pending;
}

}  // namespace leitstand
