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

/// When a robot is considered to stand.
struct StandingRules {
    double speed = 0.01;     ///< largest speed [m/s]
    double turnRate = 0.02;  ///< largest turn rate [rad/s]
    /// Both must hold for this time without interruption.
    std::chrono::nanoseconds after = std::chrono::milliseconds(200);
    std::chrono::nanoseconds fresh = std::chrono::seconds(1);  ///< older odometry is ignored
};

/// Decides whether a robot stands, from its odometry. Pure.
class StandingJudge {
public:
    explicit StandingJudge(const StandingRules& rules = {});
    /// Takes @p speed [m/s] and @p turnRate [rad/s]; NaN counts as motion.
    void moved(double speed, double turnRate, SteadyTime now);
    [[nodiscard]] bool isStanding(SteadyTime now) const;
    [[nodiscard]] bool isKnown(SteadyTime now) const;  ///< whether odometry was received recently

private:
    StandingRules m_rules;
    std::optional<SteadyTime> m_received, m_atRest;
};

/// The stop of a robot, which stays in force until it is released (docs/design.md, "The wire"). Pure: no
/// clock, no thread.
///
/// - Any stop is obeyed, from any station and with any number, since a restarted station may have smaller
///   numbers. Only a repetition of the very last command of a process is ignored: a repeated stop would
///   undo a release.
/// - A release is obeyed if it comes from the holder of the drive grant, its number is the highest of its
///   process, and it names the newest stop (StopStateSample::stops). A replayed release, or one that was
///   given before another stop, releases nothing.
/// - The answer to a command has its number, also when the command is a repetition. Stamps are ignored.
class StopLatch {
public:
    /// @p stops: first count of stops. No earlier run of the robot may have used it; the nanoseconds of the
    /// robot's clock are suitable.
    explicit StopLatch(std::uint64_t stops = 0);

    /// Obeys or refuses @p command and returns the answer; the caller sets its header and standing.
    /// @p fromHolder: whether @p from holds the drive grant.
    [[nodiscard]] StopStateSample receive(const StopCommandSample& command, const Sender& from,
                                          bool fromHolder);
    void press();  ///< takes a press of the robot's own stop button

    [[nodiscard]] bool isStopped() const { return m_state.stopped; }
    /// The newest answer, updated to the present state of the stop.
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
