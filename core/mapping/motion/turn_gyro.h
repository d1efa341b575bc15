#pragma once

#include <chrono>
#include <deque>
#include <optional>

#include "core/base/time.h"

namespace leitstand {

/// How far a robot turned about the vertical, by its gyros: for moments without odometry. Stamps are the
/// robot's clock. One thread at a time.
class TurnGyro {
public:
    static constexpr std::chrono::milliseconds LongestStep{100};  ///< longest gap between rates of one run

    /// Adds @p rate about the vertical, counter-clockwise [rad/s]. NaN and rates out of order are left out.
    /// When the clock jumps back, the rates so far are dropped.
    void add(Time stamp, double rate);
    /// Returns the turn from @p from to @p to, which must be later [rad]; empty if there is a gap between
    /// rates. The newest rate is used up to LongestStep beyond its stamp.
    [[nodiscard]] std::optional<double> turned(Time from, Time to) const;
    void forgetBefore(Time stamp);
    void clear() { m_rates.clear(); }

private:
    struct Rate {
        Time stamp;
        double rate = 0.0;   ///< [rad/s]
        double since = 0.0;  ///< turn since the first one of its run [rad]
        int run = 0;         ///< rises with every gap
    };
    struct Moment {
        double since = 0.0;
        int run = 0;
    };
    [[nodiscard]] std::optional<Moment> at(Time stamp) const;

    std::deque<Rate> m_rates;  ///< by stamp
};

}  // namespace leitstand
