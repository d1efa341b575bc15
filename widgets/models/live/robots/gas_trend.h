#pragma once

#include <deque>
#include <utility>
#include <vector>

#include "core/base/time.h"

namespace leitstand {

/// How the concentration of a gas went over the last two minutes.
class GasTrend {
public:
    static constexpr double Span = 120.0;  ///< [s]

    /// @p ppm at @p at, of one clock; what goes back in time begins anew, the same moment twice counts once.
    void add(Time at, double ppm);
    void clear() { m_samples.clear(); }

    /// Age [s] and value [ppm], oldest first.
    [[nodiscard]] std::vector<std::pair<double, double>> samples(Time now) const;
    /// Rise over the last 20 s of samples [ppm/min]; 0 while that is not known.
    [[nodiscard]] double risePerMinute() const;

private:
    std::deque<std::pair<Time, double>> m_samples;
};

}  // namespace leitstand
