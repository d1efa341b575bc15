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
#include "core/robot/control/stop/stop_status.h"
#include "core/robot/link/link_status.h"

namespace leitstand {

/// Times for stopping a robot from the station.
struct StopTiming {
    /// Between repeats, until the stop is acknowledged.
    std::chrono::nanoseconds repeat = std::chrono::milliseconds(100);
    /// An unanswered release is revoked after this long.
    std::chrono::nanoseconds release = std::chrono::seconds(2);
    StandingRules standing = {};
};

/// Stops and releases one robot, on the station's side (docs/design.md, "The wire"). Pure.
///
/// A stop is repeated until the robot's answer has its number, however long that takes. Numbers begin with
/// the nanoseconds of the wall clock and rise by at least one, so that a restarted station uses higher
/// numbers than before. If the clock was set back, the robot still obeys (StopLatch). Stamps are only for the
/// log; nothing depends on the robot's clock. If the robot does not answer a release within 2 s, it is
/// revoked by another stop. So the robot does not start unexpectedly when the link returns.
class StopControl {
public:
    explicit StopControl(std::string station, bool supported = true, const StopTiming& timing = {});

    void stop(SteadyTime now, Time wall);
    /// Releases the robot. @p held: whether this station holds the drive grant. Errors: the grant is not
    /// held, the robot has not reported its stop, or it has not acknowledged a stop of this station yet.
    Result<void> release(bool held, SteadyTime now, Time wall);

    void receive(const StopStateSample& state);
    /// Takes @p speed [m/s] and @p turnRate [rad/s] of the robot's odometry.
    void moved(double speed, double turnRate, SteadyTime now);

    /// Returns what must be sent now, if anything. Call about every 20 ms while a command is unanswered.
    [[nodiscard]] std::optional<StopCommandSample> due(SteadyTime now, Time wall);
    /// Whether a command is unanswered.
    [[nodiscard]] bool isWaiting() const { return m_pending.has_value(); }

    [[nodiscard]] StopStatus status(SteadyTime now) const;
    /// Whether no stop of any station is in force, as far as this station knows.
    [[nodiscard]] bool allowsDriving() const;
    /// Whether the robot ignores stop commands and must be held by drive commands of zero.
    [[nodiscard]] bool holdsByZeros() const { return !m_supported && m_wanted; }
    /// Whether a stop of this station is in force.
    [[nodiscard]] bool isWanted() const { return m_wanted; }

private:
    void send(bool stop, SteadyTime now, Time wall);
    void answered(const StopStateSample& state);

    std::string m_station;
    bool m_supported;
    StopTiming m_timing;
    std::uint64_t m_number = 0;
    std::optional<StopCommandSample> m_pending;
    SteadyTime m_since = {}, m_next = {};  ///< when the pending command was made; when to send it next
    bool m_wanted = false, m_acknowledged = false;
    std::optional<StopStateSample> m_state;
    std::string m_refused;
    StandingJudge m_motion;
};

}  // namespace leitstand
