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

/// What a station sends to its guard of a robot, through a pipe, after every drive command.
struct GuardPulse {
    bool driving = false;  ///< commands go on: the next pulse comes within GuardTiming::silence
    std::chrono::nanoseconds clockAhead{0};  ///< robot's clock minus station's, for stamps
    friend bool operator==(const GuardPulse&, const GuardPulse&) = default;
};
/// Converts to and from the text "drive 1200" or "rest 0". Error: what was expected.
[[nodiscard]] std::string toString(const GuardPulse& pulse);
[[nodiscard]] Result<GuardPulse> guardPulseFrom(std::string_view text);

struct GuardTiming {
    /// Longest pause between pulses while the station drives.
    std::chrono::nanoseconds silence = std::chrono::milliseconds(200);
    std::chrono::nanoseconds zeros = std::chrono::seconds(2);         ///< how long zeros are sent
    std::chrono::nanoseconds period = std::chrono::milliseconds(50);  ///< between zeros
    /// Another sender counts as driving for this long after a command.
    std::chrono::nanoseconds others = std::chrono::seconds(1);
};

/// Decides when the guard of a robot without a watchdog sends zeros. Zeros are sent for two seconds, once a
/// station that drives sent nothing through its pipe for 0.2 s, or closed its end. None is sent beside
/// another driver: while another station holds the grant, or while commands of others are heard. The guard
/// stops sending when the station sends again. Pure: no clock, no thread.
class GuardRules {
public:
    /// @p station: identity of the guarded station.
    GuardRules(const std::string& robot, std::string station, const GuardTiming& timing = {});

    void pulse(const GuardPulse& pulse, SteadyTime now);
    void closed() { m_closed = true; }                  ///< the pipe is closed: the station is gone
    void commanded(SteadyTime now) { m_others = now; }  ///< a drive command of another sender was heard
    void receive(const GrantSample& grant, const Sender& from, SteadyTime now);

    struct Step {
        bool zero = false;                    ///< send a zero now
        bool over = false;                    ///< the guard has nothing more to do, ever
        std::optional<SteadyTime> next = {};  ///< when to call step() again; empty: when something is heard
    };
    [[nodiscard]] Step step(SteadyTime now);
    /// Whether zeros are being sent, or would be if nobody else drove.
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
