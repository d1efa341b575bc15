#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/base/time.h"
#include "core/robot/link/link_status.h"

namespace leitstand {

/// Remembers the newest pings and how long they took to be answered. Constant memory, no allocation.
class RoundTrips {
public:
    static constexpr int Remembered = 20;              ///< number of newest pings that are remembered
    static constexpr std::chrono::seconds Window{10};  ///< older answers are ignored
    static constexpr std::chrono::milliseconds Patience{1000};  ///< after this time a ping is unanswered

    /// Takes ping @p number, which is sent with @p stamp.
    void sent(std::uint64_t number, Time stamp, SteadyTime now);
    /// Takes the answer to ping @p number at @p now. @p held: time that the robot needed to answer. Returns
    /// false when that ping is not remembered or was answered before.
    bool answered(std::uint64_t number, Time stamp, std::chrono::nanoseconds held, SteadyTime now);

    /// Empty: no ping was ever answered.
    [[nodiscard]] std::optional<RoundTripStatus> status(SteadyTime now) const;
    /// Returns for how long pings have not been answered [s]. 0 while they are answered, while none is sent,
    /// or if none was ever answered.
    [[nodiscard]] double waiting(SteadyTime now) const;

private:
    struct Ping {
        std::uint64_t number = 0;
        Time stamp{};
        SteadyTime sent, answered;
        std::chrono::nanoseconds took{-1};  ///< duration; negative: not answered
        bool used = false;
    };
    std::array<Ping, Remembered> m_pings;
    std::size_t m_next = 0;
    bool m_ever = false;
    SteadyTime m_answered;  ///< when the last answer arrived
    std::chrono::nanoseconds m_last{};
};

}  // namespace leitstand
