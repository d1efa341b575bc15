#include "robots/simulation/sensors/schedule.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace leitstand::simulation {
namespace {

constexpr std::chrono::seconds LongestLag(1);
constexpr double NanosecondsOfSecond = 1e9;

}  // namespace

Schedule::Schedule(double rate, Time start) : m_rate(rate > 0.0 ? rate : 1.0), m_origin(start) {}

Time Schedule::moment(std::int64_t number) const {
    return m_origin +
           std::chrono::nanoseconds(std::llround(static_cast<double>(number) * NanosecondsOfSecond / m_rate));
}

void Schedule::setRate(double rate) {
    if (!(rate > 0.0) || rate == m_rate) return;
    const bool begun = m_next > 0;
    if (begun) m_origin = moment(m_next - 1);
    m_next = begun ? 1 : 0;
    m_rate = rate;
}

std::optional<Time> Schedule::due(Time now) {
    Time next = moment(m_next);
    if (now - next > LongestLag) {
        const std::chrono::duration<double> lag = now - LongestLag - next;
        m_next += std::max<std::int64_t>(0, static_cast<std::int64_t>(std::ceil(lag.count() * m_rate)));
        next = moment(m_next);
    }
    if (next > now) return std::nullopt;
    ++m_next;
    return next;
}

std::optional<Time> Schedule::newest(Time now) {
    std::optional<Time> last;
    while (const auto next = due(now)) last = next;
    return last;
}

}  // namespace leitstand::simulation
