#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "core/event/status_samples.h"
#include "core/robot/control/grants.h"
#include "core/robot/link/link_status.h"

namespace leitstand {

struct StopCommandSample;

/// Limits below which a robot stands.
struct StandingRules {
    double speed = 0.01;                                              ///< [m/s]
    double turnRate = 0.02;                                           ///< [rad/s]
    std::chrono::nanoseconds after = std::chrono::milliseconds(200);  ///< least time of uninterrupted rest
    std::chrono::nanoseconds fresh = std::chrono::seconds(1);         ///< older odometry does not count
};

/// Judges whether a robot stands, by its odometry. Pure.
class StandingJudge {
public:
    explicit StandingJudge(const StandingRules& rules = {});
    /// Takes @p speed [m/s] and @p turnRate [rad/s]; NaN counts as motion.
    void moved(double speed, double turnRate, SteadyTime now);
    [[nodiscard]] bool isStanding(SteadyTime now) const;
    [[nodiscard]] bool isKnown(SteadyTime now) const;  ///< whether odometry came recently

private:
    StandingRules m_rules;
    std::optional<SteadyTime> m_received, m_atRest;
};

/// The stop of a robot: stays until it is released (docs/design.md, "The wire"). Pure: no clock, no thread.
///
/// - Any stop is obeyed, from any station and with any number: a restarted station may have smaller numbers.
///   Only the very last command of a process does not count again when it is repeated: a repeated stop would
///   undo a release.
/// - A release counts when it comes from the holder of the drive grant, its number is the highest of its
///   process, and it names the newest stop (StopStateSample::stops). A replayed release, or one given before
///   another stop, releases nothing.
/// - The answer to a command carries its number, also when the command is a repeat. Stamps are never read.
class StopLatch {
public:
    /// @p stops: first count of stops. No earlier run of the robot may have used it; the nanoseconds of the
    /// robot's clock will do.
    explicit StopLatch(std::uint64_t stops = 0);

    /// Obeys or refuses @p command and returns the answer; the caller fills in its header and standing.
    /// @p fromHolder: whether @p from holds the drive grant.
    [[nodiscard]] StopStateSample receive(const StopCommandSample& command, const Sender& from,
                                          bool fromHolder);
    void press();  ///< the robot's own stop button

    [[nodiscard]] bool isStopped() const { return m_state.stopped; }
    /// The newest answer, with the current state of the stop.
    [[nodiscard]] const StopStateSample& state() const { return m_state; }

private:
    struct Last {
        std::string station;
        Sender sender;
        std::uint64_t number;
        bool stop;
        std::string refused;
    };
    Last* lastOf(const std::string& station, const Sender& from);
    [[nodiscard]] std::string whyNot(const StopCommandSample& release, const Last* last,
                                     bool fromHolder) const;

    StopStateSample m_state;
    std::deque<Last> m_lasts;  ///< newest command of each process
};

}  // namespace leitstand
