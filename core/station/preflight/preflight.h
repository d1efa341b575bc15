#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/robot/clock/far_clock.h"
#include "core/robot/control/stop/guard_view.h"
#include "core/robot/link/wire_complaint.h"
#include "core/robot/robot_description.h"
#include "core/station/preflight/brake_test.h"
#include "core/station/robot_view.h"

namespace leitstand {

/// A network card of this computer.
struct NetworkCard {
    std::string name, address;  ///< "wlan0", "192.168.0.7"
    bool up = false, loopback = false;
    bool used = false;  ///< by the station
};

/// The facts about one robot that are judged.
struct RobotFacts {
    RobotDescription robot;
    RobotView view;
    BrakeResult brake;             ///< newest
    bool brakeOverridden = false;  ///< driven although its brake test failed
    GuardView guard;               ///< of one without a watchdog that is driven nevertheless
    std::vector<WireComplaint> complaints;
};

/// Everything that the preflight page judges.
struct PreflightFacts {
    std::vector<RobotFacts> robots;
    std::vector<std::string> strangers;     ///< robots in the domain that the station does not drive
    std::vector<WireComplaint> complaints;  ///< about no robot in particular
    std::vector<std::string> limits;        ///< limits of this computer that make it lose samples
    std::vector<NetworkCard> cards;
    std::vector<std::string> environment;  ///< variables of ROS that the network follows: "ROS_DOMAIN_ID=7"
    std::string folder;                    ///< of the mission
    std::uint64_t freeBytes = 0;
    std::optional<double> writeRate;  ///< of the mission's disk [B/s]; empty: not measured yet
    double logRate = 0.0;             ///< that the log needs now [B/s]
    std::string logProblem;           ///< why nothing can be recorded; empty: all is well
    std::string gamepad;              ///< its name; empty: there is none
    std::string soundProblem;         ///< why the tones of alarms are not heard; empty: all is well
    bool secured = false;
    std::string security;               ///< our identity in words, or why there is none
    std::vector<std::string> versions;  ///< of the programs
    double farClock = FarClock;         ///< offset from which a robot's clock raises an alarm [s]
    Time now{};                         ///< station's clock
};

/// The result of a check. A note only informs: it is neither in order nor wrong.
enum class CheckState : std::uint8_t { Ok, Note, Attention, Fail };

/// One line of the page. Core finds the facts; widgets word them by kind.
struct PreflightCheck {
    enum class Kind : std::uint8_t {
        RobotConnected,  ///< number: round trip [s]; reasons: why it is degraded
        RobotMissing,    ///< never received, or lost; number: silence [s]
        StreamsComing,   ///< number: how many
        StreamsMissing,  ///< detail: which; a stream of its file that never came
        StreamsStale,    ///< detail: which stopped arriving
        PicturesFresh,   ///< number: age of the oldest camera's newest picture [s]
        PicturesOld,     ///< detail: which; number: age of the oldest [s]
        Wire,            ///< wire: what stands between a reader and a writer
        ClockSteady,     ///< number: how far the robot's clock is ahead [s]
        ClockFar,        ///< number: as for ClockSteady, but too far
        ClockUnknown,
        Grant,        ///< ours
        GrantFree,    ///< nobody's: taken when driving begins
        GrantOthers,  ///< detail: who has it
        Deaf,         ///< it receives no drive commands
        NotBound,     ///< it has no stop of its own, and knows no grants: others may drive it
        Stopped,      ///< a stop stands
        BrakePassed,  ///< number: until standing [s]; other: way [m]; brake
        BrakeOld,     ///< as BrakePassed, more than a day ago
        BrakeUntested,
        BrakeFailed,      ///< number, other, brake: as BrakePassed; guard; the robot may not be driven
        BrakeOverridden,  ///< as BrakeFailed, but the robot is driven nevertheless
        BrakeUnclear,     ///< brake: why
        Stranger,         ///< detail: name of a robot that may be added
        Network,          ///< detail: card and address that are used
        NetworkNone,      ///< no card but the computer's own
        Environment,      ///< detail: variables of ROS that the network follows
        Limits,           ///< detail: the limit and what lifts it
        Disk,             ///< number: hours that are left; other: write rate [B/s]
        DiskSlow,         ///< number: write rate [B/s]; other: rate that the log needs [B/s]
        DiskShort,        ///< number: hours that are left
        DiskBroken,       ///< detail: why nothing is recorded
        Gamepad,          ///< detail: its name
        GamepadNone,
        Sound,
        SoundNone,  ///< detail: why the tones of alarms are not heard
        Secured,    ///< detail: our identity
        Open,       ///< anybody in the network may publish
        Versions,   ///< detail
    };
    Kind kind = Kind::Versions;
    CheckState state = CheckState::Ok;
    std::string robot = {};   ///< name; empty: the station's own
    std::string detail = {};  ///< depends on the kind
    double number = 0.0, other = 0.0;
    BrakeResult brake = {};
    GuardView guard = {};
    WireComplaint wire = {};
    std::vector<LinkReason> reasons = {};
};

/// Returns what is in order, what needs a look and what prevents the mission: robot by robot in their order,
/// then the station's own.
[[nodiscard]] std::vector<PreflightCheck> preflight(const PreflightFacts& facts);
/// Returns the worst of @p checks.
[[nodiscard]] CheckState worstOf(const std::vector<PreflightCheck>& checks);

}  // namespace leitstand
