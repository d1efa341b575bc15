#include "widgets/models/live/robots/value_trend.h"

#include <chrono>
#include <cmath>

#include "core/base/time.h"

namespace leitstand {

void ValueTrend::add(Time at, double value) {
    if (!std::isfinite(value)) return;
    if (!m_samples.empty()) {
        if (at == m_samples.back().first) return;
        if (at < m_samples.back().first) m_samples.clear();
    }
    m_samples.emplace_back(at, value);
    while (secondsBetween(m_samples.front().first, at) > Span) m_samples.pop_front();
}

std::vector<std::pair<double, double>> ValueTrend::samples(Time now) const {
    std::vector<std::pair<double, double>> found;
    for (const auto& [at, value] : m_samples) {
        const double age = secondsBetween(at, now);
        if (age <= Span) found.emplace_back(age, value);
    }
    return found;
}

double ValueTrend::risePerMinute() const {
    constexpr double Window = 20.0, Enough = 5.0;  // [s]
    if (m_samples.empty()) return 0.0;
    // Least squares line.
    double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0, span = 0.0;
    for (auto one = m_samples.rbegin(); one != m_samples.rend(); ++one) {
        const double x = -secondsBetween(one->first, m_samples.back().first);
        if (x < -Window) break;
        span = -x;
        n += 1.0;
        sx += x;
        sy += one->second;
        sxx += x * x;
        sxy += x * one->second;
    }
    const double spread = n * sxx - sx * sx;
    return span < Enough || spread <= 0.0 ? 0.0 : 60.0 * (n * sxy - sx * sy) / spread;
}

}  // namespace leitstand
