#pragma once

#include <chrono>

namespace leitstand {

/// A time on a robot's or the station's clock: nanoseconds since the Unix epoch.
using Time = std::chrono::time_point<std::chrono::system_clock, std::chrono::nanoseconds>;
/// A time on this computer's monotonic clock, which is never set.
using SteadyTime = std::chrono::steady_clock::time_point;

[[nodiscard]] inline SteadyTime steadyNow() {
    return std::chrono::steady_clock::now();
}

/// @p duration in seconds.
template <class Count, class Period>
[[nodiscard]] constexpr double toSeconds(std::chrono::duration<Count, Period> duration) {
    return std::chrono::duration<double>(duration).count();
}

/// Time from @p from to @p to in seconds; negative if @p to is earlier.
template <class Clock, class From, class To>
[[nodiscard]] constexpr double secondsBetween(std::chrono::time_point<Clock, From> from,
                                              std::chrono::time_point<Clock, To> to) {
    return toSeconds(to - from);
}

}  // namespace leitstand
