#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/robot/control/grant_arbiter.h"

namespace leitstand {

/// What a station tells its guard of a robot, through a pipe, with every drive command that it has sent.
struct GuardPulse {
    bool driving = false;  ///< commands go on: the next pulse comes within GuardTiming::silence
    std::chrono::nanoseconds clockAhead{0};  ///< robot's clock minus station's, for stamps
    friend bool operator==(const GuardPulse&, const GuardPulse&) = default;
};
/// "drive 1200" or "rest 0", and back. Errors: what was expected.
[[nodiscard]] std::string toString(const GuardPulse& pulse);
[[nodiscard]] Result<GuardPulse> guardPulseFrom(std::string_view text);

struct GuardTiming {
    std::chrono::nanoseconds silence = std::chrono::milliseconds(200);  ///< of a pipe whose station drives
    std::chrono::nanoseconds zeros = std::chrono::seconds(2);         ///< are sent for so long, then no more
    std::chrono::nanoseconds period = std::chrono::milliseconds(50);  ///< between them
    std::chrono::nanoseconds others = std::chrono::seconds(1);  ///< who commanded within that is driving
};

/// When the guard of a robot without a watchdog sends zeros: for two seconds, once the station that drives
/// the robot says nothing more through its pipe for 0.2 s, or its end of the pipe is closed. Never beside
/// somebody else who drives: neither while another station holds the grant, nor where others' commands are
/// heard; and no more once the station speaks again. Pure: no clock, no thread.
class GuardRules {
public:
    /// @p station: identity of the station that is guarded.
    GuardRules(const std::string& robot, std::string station, const GuardTiming& timing = {});

    void pulse(const GuardPulse& pulse, SteadyTime now);
    void closed() { m_closed = true; }                  ///< the pipe: the station is gone
    void commanded(SteadyTime now) { m_others = now; }  ///< a drive command of somebody else was heard
    void hear(const GrantSample& grant, const Sender& from, SteadyTime now);

    struct Step {
        bool zero = false;                    ///< send one now
        bool over = false;                    ///< there is nothing more to do, ever
        std::optional<SteadyTime> next = {};  ///< look again then; empty: when something is heard
    };
    [[nodiscard]] Step step(SteadyTime now);
    /// Zeros are being sent, or would be but for somebody else who drives.
    [[nodiscard]] bool isStopping() const { return m_since.has_value(); }
    [[nodiscard]] std::chrono::nanoseconds clockAhead() const { return m_pulse.clockAhead; }

private:
    [[nodiscard]] bool othersDrive(SteadyTime now) const;

    GuardTiming m_timing;
    std::string m_station;
    GrantArbiter m_grant;
    GuardPulse m_pulse;
    SteadyTime m_heard = {}, m_sent = {};
    bool m_closed = false;
    std::optional<SteadyTime> m_others;
    std::optional<SteadyTime> m_since;  ///< of the zeros
};

}  // namespace leitstand
