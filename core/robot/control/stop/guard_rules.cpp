#include "core/robot/control/stop/guard_rules.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include <fmt/format.h>

#include "core/event/station_samples.h"

namespace leitstand {
namespace {

constexpr std::string_view Drive = "drive ", Rest = "rest ";

}  // namespace

std::string toString(const GuardPulse& pulse) {
    return fmt::format("{}{}", pulse.driving ? Drive : Rest, pulse.clockAhead.count());
}

Result<GuardPulse> guardPulseFrom(std::string_view text) {
    GuardPulse pulse;
    pulse.driving = text.starts_with(Drive);
    if (pulse.driving || text.starts_with(Rest)) {
        const std::string_view number = text.substr(pulse.driving ? Drive.size() : Rest.size());
        std::int64_t ahead = 0;
        const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), ahead);
        pulse.clockAhead = std::chrono::nanoseconds(ahead);
        if (error == std::errc() && end == number.data() + number.size()) return pulse;
    }
    return Error{"expected \"drive\" or \"rest\" and a number of nanoseconds"};
}

GuardRules::GuardRules(const std::string& robot, std::string station, const GuardTiming& timing)
    : m_timing(timing), m_station(std::move(station)), m_grant(driveGrant(robot)) {}

void GuardRules::pulse(const GuardPulse& pulse, SteadyTime now) {
    m_pulse = pulse;
    m_received = now;
    m_since.reset();
}

void GuardRules::receive(const GrantSample& grant, const Sender& from, SteadyTime now) {
    m_grant.receive(grant, from, now);
}

bool GuardRules::othersDrive(SteadyTime now) const {
    const std::string holder = m_grant.holder(now);
    return (!holder.empty() && holder != m_station) || (m_others && now - *m_others < m_timing.others);
}

GuardRules::Step GuardRules::step(SteadyTime now) {
    if (!m_pulse.driving) return {.over = m_closed};
    const SteadyTime silent = m_received + m_timing.silence;
    if (!m_since) {
        if (!m_closed && now < silent) return {.next = silent};
        m_since = now;
        m_sent = now - m_timing.period;
    }
    if (now - *m_since >= m_timing.zeros) {
        m_since.reset();
        m_pulse.driving = false;  // until it sends again
        return {.over = m_closed};
    }
    const bool due = now - m_sent >= m_timing.period;
    if (due) m_sent = now;
    return {.zero = due && !othersDrive(now),
            .next = std::min(m_sent + m_timing.period, *m_since + m_timing.zeros)};
}

}  // namespace leitstand
