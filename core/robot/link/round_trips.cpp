#include "core/robot/link/round_trips.h"

#include <algorithm>

#include "core/base/time.h"

namespace leitstand {

void RoundTrips::sent(std::uint64_t number, Time stamp, SteadyTime now) {
    Ping& ping = m_pings[m_next++ % Remembered];
    ping = {};
    ping.number = number;
    ping.stamp = stamp;
    ping.sent = now;
    ping.used = true;
}

bool RoundTrips::answered(std::uint64_t number, Time stamp, std::chrono::nanoseconds held, SteadyTime now) {
    const auto found = std::find_if(m_pings.begin(), m_pings.end(), [&](const Ping& ping) {
        return ping.used && ping.number == number && ping.stamp == stamp && ping.took.count() < 0;
    });
    if (found == m_pings.end()) return false;
    const std::chrono::nanoseconds away = std::max<std::chrono::nanoseconds>(now - found->sent, {});
    found->took = away - std::clamp<std::chrono::nanoseconds>(held, {}, away);
    found->answered = now;
    m_last = found->took;
    m_answered = now;
    m_ever = true;
    return true;
}

std::optional<RoundTripStatus> RoundTrips::status(SteadyTime now) const {
    if (!m_ever) return std::nullopt;
    std::array<std::chrono::nanoseconds, Remembered> took{};
    std::size_t count = 0;
    int asked = 0, missed = 0;
    for (const Ping& ping : m_pings) {
        if (!ping.used || now - ping.sent > Window) continue;
        if (ping.took.count() >= 0) {
            took[count++] = ping.took;
            ++asked;
        } else if (now - ping.sent > Patience) {
            ++asked;
            ++missed;
        }
    }
    RoundTripStatus status;
    status.last = toSeconds(m_last);
    status.median = status.last;
    if (count > 0) {
        const auto middle = took.begin() + static_cast<std::ptrdiff_t>(count / 2);
        std::nth_element(took.begin(), middle, took.begin() + static_cast<std::ptrdiff_t>(count));
        status.median = toSeconds(*middle);
    }
    status.age = std::max(0.0, toSeconds(now - m_answered));
    status.unanswered = asked > 0 ? static_cast<double>(missed) / asked : 0.0;
    return status;
}

double RoundTrips::waiting(SteadyTime now) const {
    const bool pinging = std::any_of(m_pings.begin(), m_pings.end(), [&](const Ping& ping) {
        return ping.used && ping.took.count() < 0 && ping.sent > m_answered;
    });
    return m_ever && pinging ? std::max(0.0, toSeconds(now - m_answered)) : 0.0;
}

}  // namespace leitstand
