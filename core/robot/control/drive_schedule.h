#pragma once

#include <chrono>

#include "core/robot/control/drive_setpoint.h"

namespace leitstand {

/// How often drive commands are sent.
struct DriveRhythm {
    std::chrono::nanoseconds period = std::chrono::milliseconds(25);    ///< repeated at 40 Hz
    std::chrono::nanoseconds shortest = std::chrono::milliseconds(10);  ///< between changes, except for zero
    int zeros = 40;  ///< sent once nobody drives; then silence, so that others may drive
};

/// Decides when the next drive command is sent: at once when it changed, and again every 25 ms. Pure. A robot
/// brakes when it receives no command for 0.2 s. A radio's delay of 50 ms leaves six commands in that time;
/// one of them always arrives, even with a loss of one in twenty. At 20 Hz three lost in a row were a
/// stutter, 2 in 10 minutes. While nobody drives it sends zero for a second and is then silent, so that it
/// overrides no navigation on board and no other station.
class DriveSchedule {
public:
    explicit DriveSchedule(const DriveRhythm& rhythm = {});

    struct Decision {
        bool send = false;
        SteadyTime next = {};  ///< when to ask again, if nothing changes before
        bool speaks = false;   ///< more commands follow within a period; else it is silent from now on
    };
    /// @p driving: somebody holds the sticks, or the robot is held by zeros.
    [[nodiscard]] Decision decide(const DriveVelocity& velocity, bool driving, SteadyTime now);

private:
    DriveRhythm m_rhythm;
    DriveVelocity m_last;
    SteadyTime m_sent = {}, m_due = {};
    int m_zerosLeft = 0;
};

}  // namespace leitstand
