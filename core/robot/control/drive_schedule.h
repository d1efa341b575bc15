#pragma once

#include <chrono>

#include "core/robot/control/drive_setpoint.h"

namespace leitstand {

/// How often drive commands are sent.
struct DriveRhythm {
    std::chrono::nanoseconds period = std::chrono::milliseconds(25);  ///< between repeated commands: 40 Hz
    /// Least time between changed commands. A change to zero is sent at once.
    std::chrono::nanoseconds shortest = std::chrono::milliseconds(10);
    /// Number of zeros sent when nobody drives any more; then silence, so that others may drive.
    int zeros = 40;
};

/// Decides when the next drive command is sent: at once when it changed, and again every 25 ms. Pure.
///
/// A robot brakes when it receives no command for 0.2 s. If a radio delays commands by 50 ms, six arrive
/// within that time; one of them arrives even if the radio loses one in twenty. At 20 Hz, three commands lost
/// in a row made the robot stutter twice in 10 minutes. When nobody drives any more, zero is sent for a
/// second and then nothing, so that navigation on board and other stations are not overridden.
class DriveSchedule {
public:
    explicit DriveSchedule(const DriveRhythm& rhythm = {});

    struct Decision {
        bool send = false;
        SteadyTime next = {};  ///< when to call decide() again if nothing changes before
        bool speaks = false;   ///< whether more commands follow within a period; false: silent from now on
    };
    /// @p driving: whether somebody holds the sticks, or zeros must hold the robot.
    [[nodiscard]] Decision decide(const DriveVelocity& velocity, bool driving, SteadyTime now);

private:
    DriveRhythm m_rhythm;
    DriveVelocity m_last;
    SteadyTime m_sent = {}, m_due = {};
    int m_zerosLeft = 0;
};

}  // namespace leitstand
