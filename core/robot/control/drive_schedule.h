#pragma once

#include <chrono>

#include "core/robot/control/drive_setpoint.h"

namespace leitstand {

/// How often drive commands are sent.
struct DriveRhythm {
    std::chrono::nanoseconds period = std::chrono::milliseconds(25);    ///< repeated at 40 Hz
    std::chrono::nanoseconds shortest = std::chrono::milliseconds(10);  ///< between changes, but for zero
    int zeros = 40;  ///< sent once nobody drives any more; then silence, so that others may
};

/// When the next drive command is to be sent: at once when it changed, and again every 25 ms. Pure. A robot
/// brakes when it hears no command for 0.2 s: of the six that a radio's delay of 50 ms leaves in that time
/// one always comes, though it loses one in twenty (at 20 Hz three lost in a row were a stutter, 2 in 10
/// minutes). While nobody drives it says zero for a second and is then silent, so that it overrides no
/// navigation on board and no other station.
class DriveSchedule {
public:
    explicit DriveSchedule(const DriveRhythm& rhythm = {});

    struct Decision {
        bool send = false;
        SteadyTime next = {};  ///< when to ask again, if nothing changes before
        bool speaks = false;   ///< more commands follow within a period; else it is silent from now on
    };
    /// @p driving: somebody has hold of the sticks, or zeros are to be held.
    [[nodiscard]] Decision decide(const DriveVelocity& velocity, bool driving, SteadyTime now);

private:
    DriveRhythm m_rhythm;
    DriveVelocity m_last;
    SteadyTime m_sent = {}, m_due = {};
    int m_zerosLeft = 0;
};

}  // namespace leitstand
