#pragma once

#include <chrono>

#include "core/robot/control/drive_setpoint.h"

namespace leitstand {

/// How often drive commands are sent.
struct DriveRhythm {
    std::chrono::nanoseconds period = std::chrono::milliseconds(25);  ///< between repeats: 40 Hz
    /// Least time between changes; a change to zero is sent at once.
    std::chrono::nanoseconds shortest = std::chrono::milliseconds(10);
    int zeros = 40;  ///< number of zeros sent once nobody drives; then silence, so that others may drive
};

/// Decides when the next drive command is sent: at once when it changed, and again every 25 ms. Pure. A robot
/// brakes when it receives no command for 0.2 s. A radio's delay of 50 ms leaves six commands in that time;
/// one of them always arrives, even with a loss of one in twenty. At 20 Hz, three commands lost in a row made
/// the robot stutter, twice in 10 minutes. Once nobody drives, zero is sent for a second and then nothing:
/// navigation on board and other stations are not overridden.
class DriveSchedule {
public:
    explicit DriveSchedule(const DriveRhythm& rhythm = {});

    struct Decision {
        bool send = false;
        SteadyTime next = {};  ///< when to call decide() again, if nothing changes before
        bool speaks = false;   ///< more commands follow within a period; false: silent from now on
    };
    /// @p driving: somebody holds the sticks, or zeros must hold the robot.
    [[nodiscard]] Decision decide(const DriveVelocity& velocity, bool driving, SteadyTime now);

private:
    DriveRhythm m_rhythm;
    DriveVelocity m_last;
    SteadyTime m_sent = {}, m_due = {};
    int m_zerosLeft = 0;
};

}  // namespace leitstand
