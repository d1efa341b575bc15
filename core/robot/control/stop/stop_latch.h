#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "core/event/command_samples.h"
#include "core/event/status_samples.h"
#include "core/robot/control/grants.h"
#include "core/robot/link/link_status.h"

namespace leitstand {

/// Below which a robot stands.
struct StandingRules {
    double speed = 0.01;                                              ///< [m/s]
    double turnRate = 0.02;                                           ///< [rad/s]
    std::chrono::nanoseconds after = std::chrono::milliseconds(200);  ///< of rest without a break
    std::chrono::nanoseconds fresh = std::chrono::seconds(1);         ///< older odometry tells nothing
};

/// Whether a robot stands, by its odometry. Pure.
class StandingJudge {
public:
    explicit StandingJudge(const StandingRules& rules = {});
    /// @p speed [m/s], @p turnRate [rad/s]; what is no number counts as motion.
    void moved(double speed, double turnRate, SteadyTime now);
    [[nodiscard]] bool isStanding(SteadyTime now) const;
    [[nodiscard]] bool isKnown(SteadyTime now) const;  ///< odometry came lately

private:
    StandingRules m_rules;
    std::optional<SteadyTime> m_heard, m_atRest;
};

/// The stop of a robot: stays until it is released (design, section 4). Pure: no clock, no thread.
///
/// - Any stop is obeyed, of whomever, whatever its number: a station that started anew with smaller numbers
///   stops as well. Only the very last command of a process, said again, does not count twice, or a repeated
///   stop would undo a release.
/// - A release counts when it comes from the holder of the drive grant, its number is the highest of its
///   process, and it names the newest stop (StopStateSample::stops): one that was given before another stop
///   was, or is replayed, releases nothing.
/// - Every command is answered, also a repeated one, by its own number. Stamps are never looked at.
class StopLatch {
public:
    /// @p stops: where the count of stops begins; anything that no earlier run of the robot has used, as the
    /// nanoseconds of its clock.
    explicit StopLatch(std::uint64_t stops = 0);

    /// Takes or refuses @p command and returns the answer; its header and standing are left to the caller.
    [[nodiscard]] StopStateSample hear(const StopCommandSample& command, const Sender& from, bool fromHolder);
    void press();  ///< the robot's own button

    [[nodiscard]] bool isStopped() const { return m_state.stopped; }
    /// The newest answer, with whether it is stopped now.
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
