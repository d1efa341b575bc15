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
    bool hold = false;      ///< zeros are sent all the time: a stop for robots that listen to none
    bool silent = false;    ///< while it may drive, nothing is sent, no zero either: a test of the watchdog
};

/// How a robot is driven.
struct DriveStreamerSettings {
    /// Asked on the streamer's thread before each command, and must not wait; none: never driven.
    std::function<DriveConditions()> conditions = {};
    /// How fast the driver may go where these sticks lead, given whether the override is held; asked
    /// likewise, also while nobody drives (then with sticks of zero). None: as fast as the robot can.
    std::function<SightCap(const DriveVelocity& sticks, bool withoutEyes)> sight = {};
    /// Robot's clock minus station's, for commands that are stamped with the robot's; asked likewise.
    std::function<std::chrono::nanoseconds()> clockAhead = {};
    /// Told on the streamer's thread of each command that was written, and when no more come for now. Must
    /// not wait.
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
    bool needsNeutral = false;    ///< the sticks have to be let go first
    std::uint64_t sent = 0;       ///< commands
    std::uint64_t unsent = 0;     ///< commands that could not be written
    int listeners = 0;            ///< readers of the commands in other processes; a robot begins with a zero
                                  ///< that it has heard
    SightCap sight = {};          ///< what caps the speed
    std::string error;            ///< why the last of those; empty when the last one was written
    friend bool operator==(const DriveStatus&, const DriveStatus&) = default;
};

/// Sends drive commands to one robot from a thread of its own (design, section 4): on change and at 40 Hz, as
/// Twist, TwistStamped (with the stamp that the robot's file wants) or, when the robot has no drive_command,
/// as speeds of its tracks [m/s] in a JointState. Zero when the sticks were not told for 200 ms, without
/// focus, grant, or while a stop stands; zeros for a second after driving, and then nothing more. Whatever
/// the input device, the speed is capped by what the driver sees; sticks that were held while nothing was
/// seen must be neutral before the robot moves again. Any thread; no call waits for the network, for the log,
/// or for anybody else.
class DriveStreamer {
public:
    /// Errors: the robot takes no drive commands, or of a type that is none; it is tracked, and its footprint
    /// tells no width.
    [[nodiscard]] static Result<std::unique_ptr<DriveStreamer>> create(Node& node,
                                                                       const RobotDescription& robot,
                                                                       DriveStreamerSettings settings);
    ~DriveStreamer();  ///< with a last zero when it was driving
    DriveStreamer(const DriveStreamer&) = delete;
    DriveStreamer& operator=(const DriveStreamer&) = delete;

    /// The sticks as they are now; to be told at least ten times a second while they are in use, neutral too.
    /// @p withoutEyes: the override of the speed cap is held; it ends with the sticks, and when it is not
    /// told.
    void set(const DriveVelocity& velocity, bool withoutEyes = false);
    void halt();                ///< zero until the sticks were neutral
    void setFocus(bool focus);  ///< off at first; off stops the robot at once
    void refresh();             ///< the conditions have changed: look at once
    [[nodiscard]] DriveStatus status() const;
    [[nodiscard]] int listeners() const;  ///< of DriveStatus, now, also while none is sent

private:
    struct State;
    explicit DriveStreamer(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
