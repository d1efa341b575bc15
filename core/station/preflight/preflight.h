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
    bool used = false;  ///< whether the station uses it
};

/// The facts about one robot that the preflight check judges.
struct RobotFacts {
    RobotDescription robot;
    RobotView view;
    BrakeResult brake;             ///< newest result
    bool brakeOverridden = false;  ///< whether it is driven although its brake test failed
    GuardView guard;               ///< for a robot without a watchdog that is driven all the same
    std::vector<WireComplaint> complaints;
};

/// All facts that the preflight check judges.
struct PreflightFacts {
    std::vector<RobotFacts> robots;
    std::vector<std::string> strangers;     ///< robots in the domain that the station does not drive
    std::vector<WireComplaint> complaints;  ///< complaints that belong to no known robot
    std::vector<std::string> limits;        ///< limits of this computer that make it lose samples
    std::vector<NetworkCard> cards;
    std::vector<std::string> environment;  ///< ROS variables that affect the network: "ROS_DOMAIN_ID=7"
    std::string folder;                    ///< folder of the mission
    std::uint64_t freeBytes = 0;
    std::optional<double> writeRate;  ///< write rate of the mission's disk [B/s]; empty: not measured yet
    double logRate = 0.0;             ///< rate that the log needs now [B/s]
    std::string logProblem;           ///< why nothing can be recorded; empty: there is no problem
    std::string gamepad;              ///< name of the gamepad; empty: there is none
    std::string soundProblem;         ///< why tones of alarms cannot be heard; empty: there is no problem
    bool secured = false;
    std::string security;               ///< this station's identity in words, or why it has none
    std::vector<std::string> versions;  ///< versions of the programs
    double farClock = FarClock;         ///< from this offset, a robot's clock raises an alarm [s]
    Time now{};                         ///< station's clock
};

/// The result of a check. A note only informs; it is neither good nor bad.
enum class CheckState : std::uint8_t { Ok, Note, Attention, Fail };

/// One line of the page. Core finds the facts; widgets put them into words by their kind.
struct PreflightCheck {
    enum class Kind : std::uint8_t {
        RobotConnected,   ///< number: round trip [s]; reasons: why it is degraded
        RobotMissing,     ///< never received, or lost; number: silence [s]
        StreamsComing,    ///< number: how many streams
        StreamsMissing,   ///< detail: streams in its file that were never received
        StreamsStale,     ///< detail: streams that are no longer received
        PicturesFresh,    ///< number: age of the oldest camera's newest picture [s]
        PicturesOld,      ///< detail: which cameras; number: age of the oldest of their newest pictures [s]
        ScannerUnplaced,  ///< detail: frames of scanners whose place nobody tells
        Wire,             ///< wire: why a reader and a writer do not match
        ClockSteady,      ///< number: how far the robot's clock is ahead [s]
        ClockFar,         ///< number: as ClockSteady, but too far
        ClockUnknown,
        Grant,        ///< this station holds it
        GrantFree,    ///< nobody holds it; it is taken when driving begins
        GrantOthers,  ///< detail: station that holds it
        Deaf,         ///< the robot receives no drive commands
        NotBound,     ///< the robot has no stop of its own and knows no grants: others may drive it
        LockHeard,    ///< detail: topic of the lock by which STOP also holds off what others send
        LockUnheard,  ///< detail: as LockHeard, but nobody listens to it
        /// detail: titles of services that STOP calls, too, and that somebody offers.
        StopServices,
        StopServicesMissing,  ///< detail: as StopServices, but nobody offers them
        Stopped,              ///< a stop is in force
        BrakePassed,          ///< number: time until it stood [s]; other: distance [m]; brake
        BrakeOld,             ///< as BrakePassed, more than a day ago
        BrakeUntested,
        BrakeFailed,      ///< number, other, brake: as BrakePassed; guard; the robot may not be driven
        BrakeOverridden,  ///< as BrakeFailed, but the robot is driven all the same
        BrakeUnclear,     ///< brake: why the test is inconclusive
        Stranger,         ///< detail: name of a robot that may be added
        Network,          ///< detail: network card and address in use
        NetworkNone,      ///< only the loopback interface
        Environment,      ///< detail: ROS variables that affect the network
        Limits,           ///< detail: the limit, and how to raise it
        Disk,             ///< number: hours that are left; other: write rate [B/s]
        DiskSlow,         ///< number: write rate [B/s]; other: rate that the log needs [B/s]
        DiskShort,        ///< number: hours that are left
        DiskBroken,       ///< detail: why nothing is recorded
        Gamepad,          ///< detail: name of the gamepad
        GamepadNone,
        Sound,
        SoundNone,  ///< detail: why tones of alarms cannot be heard
        Secured,    ///< detail: this station's identity
        Open,       ///< no security: anybody in the network may publish
        Versions,   ///< detail: versions of the programs
    };
    Kind kind = Kind::Versions;
    CheckState state = CheckState::Ok;
    std::string robot = {};   ///< name of the robot; empty: about the station itself
    std::string detail = {};  ///< its meaning depends on the kind
    double number = 0.0, other = 0.0;
    BrakeResult brake = {};
    GuardView guard = {};
    WireComplaint wire = {};
    std::vector<LinkReason> reasons = {};
};

/// Returns what is in order, what needs attention and what prevents the mission: first for each robot in
/// their order, then for the station.
[[nodiscard]] std::vector<PreflightCheck> preflight(const PreflightFacts& facts);
/// Returns the worst of @p checks.
[[nodiscard]] CheckState worstOf(const std::vector<PreflightCheck>& checks);

}  // namespace leitstand
