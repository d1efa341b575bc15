#include "core/mapping/motion/turn_gyro.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/time.h"

namespace leitstand {
namespace {

constexpr std::chrono::seconds Disorder(1);  ///< stamps that go back farther are a clock jump

}  // namespace

void TurnGyro::add(Time stamp, double rate) {
    if (!std::isfinite(rate)) return;
    Rate next{stamp, rate};
    if (!m_rates.empty() && m_rates.back().stamp - stamp > Disorder) m_rates.clear();
    if (!m_rates.empty()) {
        const Rate& last = m_rates.back();
        if (stamp <= last.stamp) return;
        const bool on = stamp - last.stamp <= LongestStep;
        next.run = on ? last.run : last.run + 1;
        if (on) next.since = last.since + 0.5 * (last.rate + rate) * toSeconds(stamp - last.stamp);
    }
    m_rates.push_back(next);
}

std::optional<TurnGyro::Moment> TurnGyro::at(Time stamp) const {
    const auto next = std::lower_bound(m_rates.begin(), m_rates.end(), stamp,
                                       [](const Rate& one, Time wanted) { return one.stamp < wanted; });
    if (next != m_rates.end() && next->stamp == stamp) return Moment{next->since, next->run};
    if (next == m_rates.begin()) return std::nullopt;
    const Rate& before = *std::prev(next);
    const auto after = stamp - before.stamp;
    if (after > LongestStep || (next != m_rates.end() && next->run != before.run)) return std::nullopt;
    double rate = before.rate;  // mean until the stamp
    if (next != m_rates.end())
        rate += 0.5 * (next->rate - before.rate) * toSeconds(after) / toSeconds(next->stamp - before.stamp);
    return Moment{before.since + rate * toSeconds(after), before.run};
}

std::optional<double> TurnGyro::turned(Time from, Time to) const {
    const auto begin = at(from), end = at(to);
    if (!begin || !end || begin->run != end->run) return std::nullopt;
    return end->since - begin->since;
}

void TurnGyro::forgetBefore(Time stamp) {
    // The last rate before the stamp is needed for later ones.
    while (m_rates.size() > 1 && m_rates[1].stamp <= stamp) m_rates.pop_front();
}

}  // namespace leitstand
