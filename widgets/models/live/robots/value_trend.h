#pragma once

#include <deque>
#include <utility>
#include <vector>

#include "core/base/time.h"

namespace leitstand {

/// A number that a robot measures, such as the concentration of a gas, over the last two minutes.
class ValueTrend {
public:
    static constexpr double Span = 120.0;  ///< time that is kept [s]

    /// Adds @p value at the time @p at; all times must be of the same clock. A time before the last one
    /// starts the trend again; the same time again is ignored.
    void add(Time at, double value);
    void clear() { m_samples.clear(); }

    /// Returns the samples as pairs of age [s] and value, oldest first.
    [[nodiscard]] std::vector<std::pair<double, double>> samples(Time now) const;
    /// Returns the rise over the last 20 s of samples [1/min]; 0 if it is unknown.
    [[nodiscard]] double risePerMinute() const;

private:
    std::deque<std::pair<Time, double>> m_samples;
};

}  // namespace leitstand
