#pragma once

#include <cstdint>
#include <optional>

#include "core/base/time.h"

namespace leitstand::simulation {

/// Moments at a rate, on an exact grid without drift.
class Schedule {
public:
    /// The first moment is @p start. Further moments follow every 1 / @p rate seconds.
    Schedule(double rate, Time start);

    /// Sets the rate of the moments after the last one [Hz]. Ignores a rate that is not above 0.
    void setRate(double rate);
    [[nodiscard]] double rate() const { return m_rate; }

    /// Returns the next moment, each only once; empty if it is after @p now. Skips moments that are more than
    /// a second before @p now.
    [[nodiscard]] std::optional<Time> due(Time now);
    /// Returns the last moment up to @p now and skips earlier ones; empty when none is due.
    [[nodiscard]] std::optional<Time> newest(Time now);

private:
    [[nodiscard]] Time moment(std::int64_t number) const;

    double m_rate;
    Time m_origin;
    std::int64_t m_next = 0;
};

}  // namespace leitstand::simulation
