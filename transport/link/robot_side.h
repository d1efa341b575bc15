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

/// How a robot takes commands.
struct RobotCommandSettings {
    std::chrono::nanoseconds watchdog = DriveWatchdog;  ///< the robot stops when no command comes for so long
    GrantTiming grants = {};
    StandingRules standing = {};
    std::function<Time()> clock = {};  ///< the robot's, for stamps; none: the computer's
    std::string leftTrack = "left_track", rightTrack = "right_track";  ///< joints of track commands
};

/// What became of the commands so far.
struct RobotCommandCounts {
    std::uint64_t taken = 0;
    std::uint64_t refused = 0;  ///< not of the holder, while stopped, or before a first zero
    std::uint64_t broken = 0;   ///< could not be read
    std::uint64_t stops = 0;    ///< stops and releases, repetitions too
};

/// The robot's end of the commands (docs/design.md, "The wire"; RobotRules). Receives grants, cmd_vel or
/// track_cmd, and stop_cmd, answers on stop_state, and returns how fast the robot has to move now. For robots
/// that are written with Leitstand; simulated ones and the tests use it too. Any thread.
///
/// A Twist carries no identity: a command counts when the participant (the first 12 bytes of the writer's
/// GUID) is the one whose heartbeats hold the grant. In a secured domain nobody can pretend to be another
/// participant; without security, anybody in the network can.
class RobotCommands {
public:
    /// Errors name the stream that the description lacks, or whose type is wrong.
    [[nodiscard]] static Result<std::unique_ptr<RobotCommands>> create(Node& node,
                                                                       const RobotDescription& robot,
                                                                       RobotCommandSettings settings = {});
    ~RobotCommands();
    RobotCommands(const RobotCommands&) = delete;
    RobotCommands& operator=(const RobotCommands&) = delete;

    /// Returns how the robot has to move now. Call it in its control loop, ten times a second or more.
    [[nodiscard]] DriveVelocity commanded() const;
    [[nodiscard]] bool isStopped() const;      ///< the stop is latched: the robot must not move by itself
    [[nodiscard]] std::string holder() const;  ///< identity of the station that is obeyed; may be empty
    void press();                              ///< presses the robot's own stop button
    /// Takes the robot's odometry: speed [m/s] and turn rate [rad/s]. Call it whenever the robot has measured
    /// them.
    void moved(double speed, double turnRate);
    [[nodiscard]] RobotCommandCounts counts() const;

private:
    struct State;
    explicit RobotCommands(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
