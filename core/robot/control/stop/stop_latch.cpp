#include "core/robot/control/stop/stop_latch.h"

#include <algorithm>
#include <cmath>

#include "core/event/command_samples.h"

namespace leitstand {
namespace {

constexpr std::size_t MostLasts = 64;

}  // namespace

StandingJudge::StandingJudge(const StandingRules& rules) : m_rules(rules) {}

void StandingJudge::moved(double speed, double turnRate, SteadyTime now) {
    const bool gap = !m_received || now - *m_received >= m_rules.fresh;
    const bool rest = std::abs(speed) <= m_rules.speed && std::abs(turnRate) <= m_rules.turnRate;
    m_received = now;
    if (!rest) {
        m_atRest.reset();
    } else if (gap || !m_atRest) {
        m_atRest = now;
    }
}

bool StandingJudge::isKnown(SteadyTime now) const {
    return m_received && now - *m_received < m_rules.fresh;
}

bool StandingJudge::isStanding(SteadyTime now) const {
    return isKnown(now) && m_atRest && *m_received - *m_atRest >= m_rules.after;
}

StopLatch::StopLatch(std::uint64_t stops) {
    m_state.stops = stops;
}

StopLatch::Last* StopLatch::lastOf(const std::string& station, const Sender& from) {
    const auto found = std::find_if(m_lasts.begin(), m_lasts.end(), [&](const Last& one) {
        return one.sender == from && one.station == station;
    });
    return found == m_lasts.end() ? nullptr : &*found;
}

std::string StopLatch::whyNot(const StopCommandSample& release, const Last* last, bool fromHolder) const {
    if (!fromHolder) return "only the station that holds the drive grant may release";
    if (last != nullptr && release.number <= last->number) return "the release is older than another command";
    if (m_state.stopped && release.releases != m_state.stops) return "the robot was stopped again since";
    return {};
}

StopStateSample StopLatch::receive(const StopCommandSample& command, const Sender& from, bool fromHolder) {
    Last* last = lastOf(command.station, from);
    m_state.number = command.number;
    m_state.station = command.station;
    if (last != nullptr && last->number == command.number && last->stop == command.stop) {
        m_state.refused = last->refused;
        return m_state;
    }
    if (command.stop) {
        m_state.stopped = true;
        ++m_state.stops;
        m_state.refused.clear();
    } else {
        m_state.refused = whyNot(command, last, fromHolder);
        if (m_state.refused.empty()) m_state.stopped = false;
    }
    // An older release must not hide the number of a newer command.
    if (last != nullptr && !command.stop && command.number <= last->number) return m_state;
    if (last == nullptr) {
        if (m_lasts.size() >= MostLasts) m_lasts.pop_front();
        last = &m_lasts.emplace_back(Last{command.station, from, 0, true, {}});
    }
    last->number = command.number;
    last->stop = command.stop;
    last->refused = m_state.refused;
    return m_state;
}

void StopLatch::press() {
    m_state.stopped = true;
    ++m_state.stops;
    m_state.number = 0;
    m_state.station.clear();
    m_state.refused.clear();
}

}  // namespace leitstand
