#include "core/perception/cues/gas_rise.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/time.h"

namespace leitstand {
namespace {

constexpr double Smoothing = 0.5;  // weight of a new sample
constexpr double OwnNoise = 8.0;   // of a usual sensor [ppm]
constexpr double Breath = 6000.0;  // strongest, at the mouth [ppm]
constexpr double Thinned = 0.4;    // distance in which breath thins to half [m]

}  // namespace

std::optional<GasRise> GasWatch::add(Time stamp, double ppm) {
    if (!std::isfinite(ppm) || ppm < 0.0) return std::nullopt;
    if (!m_entries.empty()) {
        const double since = secondsBetween(m_entries.back().stamp, stamp);
        if (since < -m_settings.window) m_entries.clear();  // the clock was set back
        if (since <= 0.0 && !m_entries.empty()) return std::nullopt;
    }
    const double before = m_entries.empty() ? ppm : m_entries.back().level;
    m_entries.push_back({stamp, before + Smoothing * (ppm - before)});
    while (secondsBetween(m_entries.front().stamp, stamp) > m_settings.window) m_entries.pop_front();
    GasRise now{m_entries.back().level, m_entries.back().level};
    for (const Entry& one : m_entries) now.baseline = std::min(now.baseline, one.level);
    m_newest = now;
    if (secondsBetween(m_entries.front().stamp, stamp) < m_settings.settle) return std::nullopt;
    const double noise = m_settings.noise * (OwnNoise + m_settings.shareNoise * now.level);
    if (now.rise() < std::max(m_settings.least, noise)) return std::nullopt;
    for (auto one = m_entries.rbegin(); one != m_entries.rend(); ++one) {
        if (secondsBetween(one->stamp, stamp) < m_settings.trend) continue;
        const double fell = one->level - now.level;
        if (fell > m_settings.falling * now.rise() + OwnNoise) return std::nullopt;
        break;
    }
    return now;
}

double breathReach(double rise) {
    if (!(rise > 0.0)) return 0.0;
    return Thinned * std::sqrt(std::max(0.0, Breath / rise - 1.0));
}

}  // namespace leitstand
