#pragma once

#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "core/base/time.h"
#include "core/robot/control/drive_setpoint.h"

namespace leitstand {

/// How a robot's brake is tested, and what the robot must achieve. Our own robots brake DriveWatchdog after
/// the last command. Stock robots brake later or never, so the test measures it.
struct BrakeTestSettings {
    double speed = 0.1;         ///< speed while driving [m/s]
    double neutral = 0.4;       ///< the sticks must be released for this long first [s]
    double drive = 1.0;         ///< longest time of driving before commands stop [s]
    double run = 0.5;           ///< time at full speed before commands stop [s]
    double stopTime = 0.5;      ///< longest time from the last command until the robot stands [s]
    double stopDistance = 0.1;  ///< longest distance from the last command until the robot stands [m]
    double giveUp = 1.5;  ///< if it still moves this long after the last command, it has no watchdog [s]
    double space = 0.6;   ///< free space needed ahead [m]
    double hold = 0.25;   ///< the operator's key must be reported at least this often [s]
    double start = 6.0;   ///< longest wait for grant and neutral sticks [s]
    /// The robot stands below this speed [m/s], and below ten times this turn rate [rad/s].
    double standing = 0.01;
};

/// The result of a brake test.
struct BrakeResult {
    enum class Verdict : std::uint8_t {
        Untested,
        Passed,
        Failed,        ///< it did not stop, or stopped too late or too far away
        Inconclusive,  ///< it was not driven or not observed to the end, so nothing is known
    };
    /// Why the test is inconclusive.
    enum class Cause : std::uint8_t {
        None,
        KeyLetGo,
        NotDriven,     ///< the robot may no longer be driven
        RoomUnknown,   ///< it is unknown whether there is space ahead
        NoRoom,        ///< there is too little space ahead: see `free` and `needed`
        NotAllowed,    ///< the station may not drive the robot
        Deaf,          ///< the robot receives no drive commands
        NoOdometry,    ///< no odometry arrives
        SticksHeld,    ///< the sticks were not released
        NotStanding,   ///< it moved before it was driven
        TooSlow,       ///< it did not reach its speed
        OdometryEnded  ///< no odometry arrived after commands stopped
    };
    /// What the robot does when commands stop.
    enum class Watchdog : std::uint8_t {
        Unknown,
        Stops,  ///< it stops by itself, in time or too late
        None,   ///< it does not stop: the test had to send zeros
    };
    Verdict verdict = Verdict::Untested;
    /// From the last command until it stood [s]; if it did not stop: until the test ended.
    double seconds = 0.0;
    double metres = 0.0;  ///< distance driven in that time [m]
    Cause cause = Cause::None;
    double free = 0.0, needed = 0.0;  ///< for NoRoom [m]
    Time when{};                      ///< when it was tested, station's clock
    Watchdog watchdog = Watchdog::Unknown;
    double brakesAfter = 0.0;  ///< if it stops: time from the last command until it braked [s]; 0: unknown
    /// Whether the test failed without any sign that the robot stops by itself. Such a robot must be sent
    /// zeros.
    [[nodiscard]] bool showsNoWatchdog() const {
        return verdict == Verdict::Failed && watchdog != Watchdog::Stops;
    }
    friend bool operator==(const BrakeResult&, const BrakeResult&) = default;
};

/// What the test must know about the robot.
struct BrakeFacts {
    /// Whether the station holds the grant, no stop is in force, and the robot has drive focus.
    bool mayDrive = false;
    bool listening = false;     ///< whether it receives drive commands
    bool needsNeutral = false;  ///< whether the sticks must be released first
    double spaceAhead = std::numeric_limits<double>::quiet_NaN();  ///< free space ahead [m]; NaN: unknown
};

/// Drives a robot at 0.1 m/s for up to a second, then sends nothing more, not even zeros. From odometry, the
/// test measures when the robot brakes, and how long and how far it continues. Meanwhile the operator holds a
/// key. When the key is released or anything else is missing, the test ends and zeros stop the robot. Pure:
/// no clock, no thread.
class BrakeTest {
public:
    enum class Phase : std::uint8_t { Idle, Neutral, Driving, Cut, Done };
    /// What to do with the robot's commands now.
    struct Step {
        DriveVelocity sticks = {};
        bool silent = false;  ///< whether to send nothing, not even zeros
    };

    explicit BrakeTest(const BrakeTestSettings& settings = {}) : m_settings(settings) {}

    void start(SteadyTime now);
    void hold(SteadyTime now) { m_held = now; }  ///< call while the operator holds the key
    /// Takes the newest odometry. @p stamp: robot's clock. @p position: in the odometry frame [m]. @p speed
    /// and @p turn: in the robot's own frame [m/s, rad/s].
    void odometry(Time stamp, const Eigen::Vector2d& position, double speed, double turn);
    Step step(const BrakeFacts& facts, SteadyTime now);
    void end(BrakeResult::Cause cause);  ///< ends the test as inconclusive, if it still runs

    [[nodiscard]] Phase phase() const { return m_phase; }
    [[nodiscard]] bool isRunning() const { return m_phase != Phase::Idle && m_phase != Phase::Done; }
    [[nodiscard]] const BrakeResult& result() const { return m_result; }

private:
    struct Motion {
        Time stamp{};
        Eigen::Vector2d position = Eigen::Vector2d::Zero();
        double speed = 0.0, turn = 0.0;
    };
    void enter(Phase phase, SteadyTime now);
    void finish(BrakeResult::Verdict verdict, BrakeResult::Watchdog watchdog, double seconds, double metres);
    [[nodiscard]] bool isStanding() const;
    Step neutral(const BrakeFacts& facts, SteadyTime now);
    Step drive(SteadyTime now);
    Step watch(SteadyTime now);

    BrakeTestSettings m_settings;
    Phase m_phase = Phase::Idle;
    SteadyTime m_since = {}, m_held = {};
    std::optional<SteadyTime> m_released;  ///< since when the sticks have been released
    std::optional<SteadyTime> m_moving;    ///< since when it has driven at speed
    std::optional<Motion> m_newest, m_cut;
    Time m_atSpeed{};  ///< newest stamp after the last command at which it had not braked yet
    BrakeResult m_result;
};

}  // namespace leitstand
