#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/event/command_samples.h"
#include "core/event/status_samples.h"
#include "core/robot/control/stop/stop_latch.h"
#include "core/robot/link/link_status.h"

namespace leitstand {

/// Times of a stop at the station.
struct StopTiming {
    std::chrono::nanoseconds repeat = std::chrono::milliseconds(100);  ///< until it is acknowledged
    std::chrono::nanoseconds release = std::chrono::seconds(2);        ///< unanswered, it is taken back
    StandingRules standing = {};
};

/// The stop of one robot as its operator sees it.
struct StopStatus {
    bool supported = true;       ///< the robot listens to stops; else only its drive commands become zero
    bool sent = false;           ///< a stop of this station stands
    bool acknowledged = false;   ///< ... and the robot has taken it
    bool stopped = false;        ///< by whomever, as the robot says
    bool standing = false;       ///< it does not move
    bool standingKnown = false;  ///< whether anything tells so
    bool releasing = false;      ///< a release is on its way
    std::string stoppedBy;  ///< identity of the station that the robot answered last; empty: its own button
    std::string refused;    ///< why the last release did nothing; until the next command
    std::chrono::nanoseconds unanswered{};  ///< how long the robot has not answered; 0 when it has
    friend bool operator==(const StopStatus&, const StopStatus&) = default;
};

/// Stops one robot and lets it go again, on the side of the station (design, section 4). Pure.
///
/// A stop is repeated until the robot's answer carries its number, however long that takes. Numbers begin
/// with the nanoseconds of the wall clock and rise by one at least, so that a station that started anew is
/// above its earlier self; if its clock was set back, the robot obeys nevertheless (StopLatch). Stamps are
/// for the log; nothing depends on the robot's clock. A release that the robot does not answer within 2 s is
/// taken back by another stop: it shall not surprise anybody when the link is back.
class StopControl {
public:
    explicit StopControl(std::string station, bool supported = true, const StopTiming& timing = {});

    void stop(SteadyTime now, Time wall);
    /// Lets the robot go. Errors: the grant to drive is not @p held, nothing is known of the robot's stop, or
    /// a stop of our own is not acknowledged yet.
    Result<void> release(bool held, SteadyTime now, Time wall);

    void hear(const StopStateSample& state);
    /// @p speed [m/s], @p turnRate [rad/s] by the robot's odometry.
    void moved(double speed, double turnRate, SteadyTime now);

    /// What is to be sent now, if anything; to be asked every 20 ms or so while it is not answered.
    [[nodiscard]] std::optional<StopCommandSample> due(SteadyTime now, Time wall);
    [[nodiscard]] bool isWaiting() const { return m_pending.has_value(); }  ///< something is unanswered

    [[nodiscard]] StopStatus status(SteadyTime now) const;
    /// No stop stands, of whomever, as far as the station knows.
    [[nodiscard]] bool allowsDriving() const;
    /// The robot listens to no stops and has to be held by drive commands of zero.
    [[nodiscard]] bool holdsByZeros() const { return !m_supported && m_wanted; }

private:
    void send(bool stop, SteadyTime now, Time wall);
    void answered(const StopStateSample& state);

    std::string m_station;
    bool m_supported;
    StopTiming m_timing;
    std::uint64_t m_number = 0;
    std::optional<StopCommandSample> m_pending;
    SteadyTime m_since = {}, m_next = {};  ///< of the pending one
    bool m_wanted = false, m_acknowledged = false;
    std::optional<StopStateSample> m_state;
    std::string m_refused;
    StandingJudge m_motion;
};

}  // namespace leitstand
