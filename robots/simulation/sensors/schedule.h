#pragma once

#include <cstdint>
#include <optional>

#include "core/base/time.h"

namespace leitstand::simulation {

/// Moments at a rate, on an exact grid that does not drift.
class Schedule {
public:
    /// The first moment is @p start, then one every 1 / @p rate seconds.
    Schedule(double rate, Time start);

    /// From the last moment on at another rate [Hz]; one that is not above 0 is left out.
    void setRate(double rate);
    [[nodiscard]] double rate() const { return m_rate; }

    /// The next moment when it is not after @p now, each once. Those more than a second ago are left out.
    [[nodiscard]] std::optional<Time> due(Time now);
    /// The last moment that is not after @p now; earlier ones are left out.
    [[nodiscard]] std::optional<Time> newest(Time now);

private:
    [[nodiscard]] Time moment(std::int64_t number) const;

    double m_rate;
    Time m_origin;
    std::int64_t m_next = 0;
};

}  // namespace leitstand::simulation
