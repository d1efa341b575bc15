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

/// What decides whether a robot is driven, beside the operator's focus.
struct DriveConditions {
    bool mayDrive = false;  ///< the grant is held and no stop stands
    bool hold = false;      ///< zeros are sent all the time: the stop for robots without a stop_command
    bool silent = false;    ///< nothing is sent while driving is allowed, no zeros either: a watchdog test
};

/// How a robot is driven.
struct DriveStreamerSettings {
    /// Called on the streamer's thread before each command; must not wait. None: never driven.
    std::function<DriveConditions()> conditions = {};
    /// Returns the cap on the speed in the direction of these sticks. `withoutEyes`: the driver holds the
    /// override. Called like `conditions`, also while nobody drives (then with sticks of zero). None: as fast
    /// as the robot can.
    std::function<SightCap(const DriveVelocity& sticks, bool withoutEyes)> sight = {};
    /// Returns robot's clock minus station's, for commands stamped with the robot's clock. Called like
    /// `conditions`.
    std::function<std::chrono::nanoseconds()> clockAhead = {};
    /// Called on the streamer's thread after each written command, and when no more follow for now. Must not
    /// wait.
    std::function<void(const GuardPulse&)> onPulse = {};
    std::chrono::nanoseconds lifetime = std::chrono::milliseconds(200);  ///< of a setpoint
    DriveRhythm rhythm = {};
    std::string leftTrack = "left_track", rightTrack = "right_track";  ///< joints of track commands
};

/// What the streamer does now.
struct DriveStatus {
    DriveVelocity velocity = {};  ///< as sent last
    bool focus = false;           ///< as set
    bool driving = false;         ///< permitted, with a fresh setpoint
    bool needsNeutral = false;    ///< the sticks must be neutral first
    std::uint64_t sent = 0;       ///< commands
    std::uint64_t unsent = 0;     ///< commands that could not be written
    int listeners = 0;    ///< readers of the commands in other processes; robots move only after a zero
    SightCap sight = {};  ///< what caps the speed
    std::string error;    ///< why the last command was not written; empty when it was
    friend bool operator==(const DriveStatus&, const DriveStatus&) = default;
};

/// Sends drive commands to one robot from a thread of its own (docs/design.md, "The wire"), on change and at
/// 40 Hz. Sends a Twist, a TwistStamped (with the stamp that the robot's file wants) or, when the robot has
/// no drive_command, speeds of its tracks [m/s] in a JointState. Sends zero when the sticks were not set for
/// 200 ms, without focus, without grant, or while a stop stands. After driving, sends zeros for a second, and
/// then nothing more. The speed is capped by what the driver sees, whatever the input device. Sticks that
/// were held while the driver saw nothing (cap 0) must be neutral before the robot moves again. Any thread;
/// no call waits for the network, for the log, or for anybody else.
class DriveStreamer {
public:
    /// Errors: the robot takes no drive commands, their type is wrong, or it is tracked and its footprint has
    /// no width.
    [[nodiscard]] static Result<std::unique_ptr<DriveStreamer>> create(Node& node,
                                                                       const RobotDescription& robot,
                                                                       DriveStreamerSettings settings);
    ~DriveStreamer();  ///< sends a last zero when it was driving
    DriveStreamer(const DriveStreamer&) = delete;
    DriveStreamer& operator=(const DriveStreamer&) = delete;

    /// Sets the sticks as they are now. Call it at least ten times a second while they are in use, also when
    /// neutral. @p withoutEyes: the driver holds the override of the speed cap. The override ends with the
    /// next set() without it, or when the sticks expire.
    void set(const DriveVelocity& velocity, bool withoutEyes = false);
    void halt();                ///< sends zero until the sticks were neutral
    void setFocus(bool focus);  ///< off at first; off stops the robot at once
    void refresh();             ///< checks changed conditions at once
    [[nodiscard]] DriveStatus status() const;
    [[nodiscard]] int listeners() const;  ///< counted now, also while nothing is sent; as in DriveStatus

private:
    struct State;
    explicit DriveStreamer(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
