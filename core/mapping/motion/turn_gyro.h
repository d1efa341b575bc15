#pragma once

#include <chrono>
#include <deque>
#include <optional>

#include "core/base/time.h"

namespace leitstand {

/// How far a robot turned about the vertical, by its gyros: for moments of which its odometry says nothing.
/// Stamps are the robot's clock. One thread at a time.
class TurnGyro {
public:
    static constexpr std::chrono::milliseconds LongestStep{100};  ///< between rates that belong together

    /// @p rate: about the vertical, counter-clockwise [rad/s]; NaN is passed by, and so is what comes out of
    /// order; a clock that jumped back begins anew.
    void add(Time stamp, double rate);
    /// From @p from to @p to, which is later [rad]; empty where no rates tell it without a gap. Beyond the
    /// newest rate, that counts on for LongestStep.
    [[nodiscard]] std::optional<double> turned(Time from, Time to) const;
    void forgetBefore(Time stamp);
    void clear() { m_rates.clear(); }

private:
    struct Rate {
        Time stamp;
        double rate = 0.0;   ///< [rad/s]
        double since = 0.0;  ///< turned since the first one of its run [rad]
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
