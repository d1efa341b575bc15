#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "core/robot/control/drive_setpoint.h"
#include "core/robot/control/grant_arbiter.h"
#include "core/robot/control/stop/stop_latch.h"

namespace leitstand {

struct GrantSample;
struct StopCommandSample;

/// How a robot treats commands.
struct RobotRuleSettings {
    DriveLimits limits = {};
    std::chrono::nanoseconds watchdog = DriveWatchdog;  ///< the robot stops after this long without a command
    GrantTiming grants = {};
    StandingRules standing = {};
    std::uint64_t firstStop = 0;  ///< first count of stops, for StopLatch
    /// A command of zero may arrive this long before its grant.
    std::chrono::nanoseconds early = std::chrono::seconds(1);
    /// Behaves like a stock robot without a watchdog: the newest command of any sender is obeyed for ever.
    /// STOP is still obeyed.
    bool careless = false;
};

/// Result of a drive command.
enum class DriveVerdict : std::uint8_t {
    Taken,
    NotHolder,   ///< it came from a process that does not hold the grant
    Stopped,     ///< the robot is stopped
    NotNeutral,  ///< after a stop, a new holder or a long silence, the first command must be zero
    NoNumber,    ///< one of its numbers is not finite: the command stops the robot
};

/// All rules of design section 4 that the robot itself enforces: whose commands it obeys, for how long, and
/// when it must not move at all. Pure: no clock, no thread. A robot that takes its commands through these
/// rules is safe from faulty stations: two that drive at once, a silent station, old releases.
class RobotRules {
public:
    explicit RobotRules(const std::string& robot, const RobotRuleSettings& settings = {});

    void receive(const GrantSample& sample, const Sender& from, SteadyTime now);
    DriveVerdict drive(const DriveVelocity& velocity, const Sender& from, SteadyTime now);
    /// Takes a stop or release and returns the answer. The caller adds a header and sends it.
    [[nodiscard]] StopStateSample receive(const StopCommandSample& command, const Sender& from,
                                          SteadyTime now);
    void press();  ///< takes a press of the robot's own stop button
    /// Takes @p speed [m/s] and @p turnRate [rad/s] of the robot's odometry.
    void moved(double speed, double turnRate, SteadyTime now);

    /// Returns how the robot must move at @p now. It depends only on what was received. Call it in the
    /// control loop.
    [[nodiscard]] DriveVelocity commanded(SteadyTime now) const;
    [[nodiscard]] bool isStopped() const { return m_latch.isStopped(); }
    [[nodiscard]] StopStateSample stopState(SteadyTime now) const;
    [[nodiscard]] const GrantArbiter& grant() const { return m_grant; }

private:
    DriveVerdict obeyAnybody(const DriveVelocity& velocity);

    RobotRuleSettings m_settings;
    GrantArbiter m_grant;
    StopLatch m_latch;
    StandingJudge m_motion;
    DriveVelocity m_velocity;
    Sender m_driver = {};
    SteadyTime m_driven = {};
    bool m_neutral = false;         ///< whether a zero arrived since the last stop or change of holder
    std::uint64_t m_neutralIn = 0;  ///< GrantArbiter::changes() when that zero arrived
    std::optional<std::pair<Sender, SteadyTime>>
        m_earlyZero;  ///< newest zero since the stop from a sender that was not obeyed then
};

}  // namespace leitstand
