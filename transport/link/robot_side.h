#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/robot/control/robot_rules.h"
#include "core/robot/robot_description.h"
#include "transport/dds/node.h"

namespace leitstand {

/// How a robot treats commands.
struct RobotCommandSettings {
    std::chrono::nanoseconds watchdog = DriveWatchdog;  ///< the robot stops after this time without a command
    GrantTiming grants = {};
    StandingRules standing = {};
    std::function<Time()> clock = {};  ///< the robot's clock, for stamps; empty: the computer's clock
    /// Names of the joints in track commands.
    std::string leftTrack = "left_track", rightTrack = "right_track";
};

/// How many commands were received so far, and how they were treated.
struct RobotCommandCounts {
    std::uint64_t taken = 0;
    std::uint64_t refused = 0;  ///< not from the holder, or received while stopped or before a first zero
    std::uint64_t broken = 0;   ///< could not be read
    std::uint64_t stops = 0;    ///< stops and releases, including repetitions
};

/// Receives commands on the robot (docs/design.md, "The wire"; RobotRules). Reads grants, cmd_vel or
/// track_cmd, and stop_cmd, answers on stop_state, and returns how the robot must move now. For robots whose
/// software uses Leitstand; simulated robots and tests use it, too. Any thread.
///
/// A Twist has no identity of its sender. A command is obeyed if its participant (the first 12 bytes of the
/// writer's GUID) is the one whose heartbeats hold the grant. In a secured domain nobody can pretend to be
/// another participant; without security, anybody in the network can.
class RobotCommands {
public:
    /// Errors name the stream that is missing in the description, or whose type is wrong.
    [[nodiscard]] static Result<std::unique_ptr<RobotCommands>> create(Node& node,
                                                                       const RobotDescription& robot,
                                                                       RobotCommandSettings settings = {});
    ~RobotCommands();
    RobotCommands(const RobotCommands&) = delete;
    RobotCommands& operator=(const RobotCommands&) = delete;

    /// Returns how the robot must move now. Call it in the control loop, at least ten times a second.
    [[nodiscard]] DriveVelocity commanded() const;
    [[nodiscard]] bool isStopped() const;  ///< whether a stop is in force: the robot must not move by itself
    [[nodiscard]] std::string holder() const;  ///< identity of the station that is obeyed; may be empty
    void press();                              ///< presses the robot's own stop button
    /// Takes @p speed [m/s] and @p turnRate [rad/s] from the robot's odometry. Call it whenever they were
    /// measured.
    void moved(double speed, double turnRate);
    [[nodiscard]] RobotCommandCounts counts() const;

private:
    struct State;
    explicit RobotCommands(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
