#pragma once

#include <deque>
#include <utility>
#include <vector>

#include "core/base/time.h"

namespace leitstand {

/// The concentration of a gas over the last two minutes.
class GasTrend {
public:
    static constexpr double Span = 120.0;  ///< time that is kept [s]

    /// Adds the concentration @p ppm at the time @p at; all times must be of the same clock. A time before
    /// the last one starts the trend again; the same time again is ignored.
    void add(Time at, double ppm);
    void clear() { m_samples.clear(); }

    /// Returns the samples as pairs of age [s] and value [ppm], oldest first.
    [[nodiscard]] std::vector<std::pair<double, double>> samples(Time now) const;
    /// Returns the rise over the last 20 s of samples [ppm/min]; 0 if it is unknown.
    [[nodiscard]] double risePerMinute() const;

private:
    std::deque<std::pair<Time, double>> m_samples;
};

}  // namespace leitstand
