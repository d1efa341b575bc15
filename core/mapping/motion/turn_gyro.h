#pragma once

#include <chrono>
#include <deque>
#include <optional>

#include "core/base/time.h"

namespace leitstand {

/// How far a robot has turned about the vertical, measured by its gyros. Used for times without odometry.
/// Stamps are the robot's clock. One thread at a time.
class TurnGyro {
public:
    /// Longest gap between rates that belong together.
    static constexpr std::chrono::milliseconds LongestStep{100};

    /// Adds @p rate about the vertical, counter-clockwise [rad/s]. Ignores NaN and rates out of order. When
    /// the clock jumps back, earlier rates are dropped.
    void add(Time stamp, double rate);
    /// Returns the turn from @p from to the later @p to [rad]; empty if there is a gap between rates. The
    /// newest rate is used up to LongestStep after its stamp.
    [[nodiscard]] std::optional<double> turned(Time from, Time to) const;
    void forgetBefore(Time stamp);
    void clear() { m_rates.clear(); }

private:
    struct Rate {
        Time stamp;
        double rate = 0.0;   ///< [rad/s]
        double since = 0.0;  ///< turn since the first rate without a gap [rad]
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
