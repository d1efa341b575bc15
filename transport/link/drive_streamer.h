#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/robot/control/drive_schedule.h"
#include "core/robot/control/drive_setpoint.h"
#include "core/robot/control/stop/guard_rules.h"
#include "core/robot/robot_description.h"
#include "core/station/sight_cap.h"
#include "transport/dds/node.h"

namespace leitstand {

/// Conditions, besides the operator's focus, that decide whether a robot is driven.
struct DriveConditions {
    bool mayDrive = false;  ///< the grant is held and no stop is in force
    bool hold = false;      ///< zeros are sent continuously: this stops robots that have no stop_command
    /// Nothing is sent while driving is allowed, not even zeros: for the test of a watchdog.
    bool silent = false;
};

/// How a robot is driven.
struct DriveStreamerSettings {
    /// Called on the streamer's thread before each command; must not wait. Empty: the robot is never driven.
    std::function<DriveConditions()> conditions = {};
    /// Returns the limit of the speed in the direction of these sticks. `withoutEyes`: the driver holds the
    /// override. Called like `conditions`, also while nobody drives (then with sticks of zero). Empty: no
    /// limit except the robot's own.
    std::function<SightCap(const DriveVelocity& sticks, bool withoutEyes)> sight = {};
    /// Returns robot's clock minus station's clock, for commands with stamps of the robot's clock. Called
    /// like `conditions`.
    std::function<std::chrono::nanoseconds()> clockAhead = {};
    /// Called on the streamer's thread after each command that was written, and when no more follow for now.
    /// Must not wait.
    std::function<void(const GuardPulse&)> onPulse = {};
    std::chrono::nanoseconds lifetime = std::chrono::milliseconds(200);  ///< lifetime of a setpoint
    DriveRhythm rhythm = {};
    /// Names of the joints in track commands.
    std::string leftTrack = "left_track", rightTrack = "right_track";
};

/// What the streamer does now.
struct DriveStatus {
    DriveVelocity velocity = {};  ///< velocity that was sent last
    bool focus = false;           ///< result of setFocus()
    bool driving = false;         ///< driving is permitted, and the setpoint is fresh
    bool needsNeutral = false;    ///< the sticks must be neutral first
    std::uint64_t sent = 0;       ///< number of commands that were sent
    std::uint64_t unsent = 0;     ///< number of commands that could not be written
    int listeners = 0;    ///< number of processes that receive the commands; robots move only after a zero
    SightCap sight = {};  ///< what limits the speed
    std::string error;    ///< why the last command was not written; empty: it was written
    friend bool operator==(const DriveStatus&, const DriveStatus&) = default;
};

/// Sends drive commands to one robot from its own thread (docs/design.md, "The wire"): at each change and at
/// 40 Hz. Sends a Twist, a TwistStamped (with the stamp that the robot's file requires) or, if the robot has
/// no drive_command, speeds of its tracks [m/s] in a JointState. Sends zero when the sticks were not set for
/// 200 ms, without focus, without the grant, or while a stop is in force. After driving, sends zeros for a
/// second, and then nothing more. What the driver sees limits the speed, for any input device. If sticks were
/// held while the driver saw nothing (limit 0), they must be neutral before the robot moves again. Any
/// thread; no call waits for the network, for the log, or for anything else.
class DriveStreamer {
public:
    /// Errors: the robot takes no drive commands, their type is wrong, or it is tracked and its footprint has
    /// no width.
    [[nodiscard]] static Result<std::unique_ptr<DriveStreamer>> create(Node& node,
                                                                       const RobotDescription& robot,
                                                                       DriveStreamerSettings settings);
    ~DriveStreamer();  ///< sends a last zero if it was driving
    DriveStreamer(const DriveStreamer&) = delete;
    DriveStreamer& operator=(const DriveStreamer&) = delete;

    /// Sets the present position of the sticks. Call at least ten times a second while they are in use, also
    /// when they are neutral. @p withoutEyes: whether the driver holds the override of the speed limit. The
    /// override ends with the next set() without it, or when the sticks expire.
    void set(const DriveVelocity& velocity, bool withoutEyes = false);
    void halt();                ///< sends zero until the sticks were neutral
    void setFocus(bool focus);  ///< off at first; switching it off stops the robot at once
    void refresh();             ///< checks changed conditions at once
    [[nodiscard]] DriveStatus status() const;
    [[nodiscard]] int listeners() const;  ///< number at present, even while nothing is sent; see DriveStatus

private:
    struct State;
    explicit DriveStreamer(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
