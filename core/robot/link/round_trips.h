#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/base/time.h"
#include "core/robot/link/link_status.h"

namespace leitstand {

/// Remembers the newest pings and how long their answers took. Constant memory, no allocation.
class RoundTrips {
public:
    static constexpr int Remembered = 20;                       ///< newest pings
    static constexpr std::chrono::seconds Window{10};           ///< older answers do not count
    static constexpr std::chrono::milliseconds Patience{1000};  ///< then a ping counts as unanswered

    /// Takes ping @p number, which is being sent with @p stamp.
    void sent(std::uint64_t number, Time stamp, SteadyTime now);
    /// Takes the answer to ping @p number at @p now; the robot held the ping for @p held. False when that
    /// ping is not remembered or was answered before.
    bool answered(std::uint64_t number, Time stamp, std::chrono::nanoseconds held, SteadyTime now);

    [[nodiscard]] std::optional<RoundTripStatus> status(SteadyTime now) const;  ///< empty: never answered
    /// Returns for how long pings have been sent without an answer [s]. 0 while they are answered, none is
    /// sent, or none was ever answered.
    [[nodiscard]] double waiting(SteadyTime now) const;

private:
    struct Ping {
        std::uint64_t number = 0;
        Time stamp{};
        SteadyTime sent, answered;
        std::chrono::nanoseconds took{-1};  ///< negative: not answered
        bool used = false;
    };
    std::array<Ping, Remembered> m_pings;
    std::size_t m_next = 0;
    bool m_ever = false;
    SteadyTime m_answered;  ///< last answer
    std::chrono::nanoseconds m_last{};
};

}  // namespace leitstand
