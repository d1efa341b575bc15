#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/robot/control/grant_arbiter.h"

namespace leitstand {

struct GrantSample;

/// A message from a station to its guard of a robot, through a pipe, after every drive command.
struct GuardPulse {
    bool driving = false;  ///< whether commands continue: the next pulse follows within GuardTiming::silence
    std::chrono::nanoseconds clockAhead{0};  ///< robot's clock minus station's clock, used for stamps
    friend bool operator==(const GuardPulse&, const GuardPulse&) = default;
};
/// Converts to and from the text "drive 1200" or "rest 0". The error says what was expected.
[[nodiscard]] std::string toString(const GuardPulse& pulse);
[[nodiscard]] Result<GuardPulse> guardPulseFrom(std::string_view text);

struct GuardTiming {
    /// Longest time between pulses while the station drives.
    std::chrono::nanoseconds silence = std::chrono::milliseconds(200);
    std::chrono::nanoseconds zeros = std::chrono::seconds(2);         ///< how long zeros are sent
    std::chrono::nanoseconds period = std::chrono::milliseconds(50);  ///< time between zeros
    /// Another sender is assumed to drive for this long after a command.
    std::chrono::nanoseconds others = std::chrono::seconds(1);
};

/// Decides when the guard of a robot without a watchdog sends zeros. It sends them for two seconds if a
/// driving station has sent nothing through its pipe for 0.2 s, or has closed it. It sends none while
/// somebody else drives: another station holds the grant, or commands of others are heard. It stops when the
/// station sends again. Pure: no clock, no thread.
class GuardRules {
public:
    /// @p station: identity of the station that is guarded.
    GuardRules(const std::string& robot, std::string station, const GuardTiming& timing = {});

    void pulse(const GuardPulse& pulse, SteadyTime now);
    void closed() { m_closed = true; }  ///< call when the pipe is closed: the station is gone
    /// Call when a drive command of another sender was heard.
    void commanded(SteadyTime now) { m_others = now; }
    void receive(const GrantSample& grant, const Sender& from, SteadyTime now);

    struct Step {
        bool zero = false;  ///< whether to send a zero now
        bool over = false;  ///< whether the guard will never have anything to do again
        /// When to call step() again; empty: when something is received.
        std::optional<SteadyTime> next = {};
    };
    [[nodiscard]] Step step(SteadyTime now);
    /// Whether zeros are being sent, or would be sent if nobody else drove.
    [[nodiscard]] bool isStopping() const { return m_since.has_value(); }
    [[nodiscard]] std::chrono::nanoseconds clockAhead() const { return m_pulse.clockAhead; }

private:
    [[nodiscard]] bool othersDrive(SteadyTime now) const;

    GuardTiming m_timing;
    std::string m_station;
    GrantArbiter m_grant;
    GuardPulse m_pulse;
    SteadyTime m_received = {}, m_sent = {};
    bool m_closed = false;
    std::optional<SteadyTime> m_others;
    std::optional<SteadyTime> m_since;  ///< when the zeros began
};

}  // namespace leitstand
