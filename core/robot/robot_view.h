#pragma once

#include <optional>

#include "core/perception/virtual_scan_view.h"
#include "core/robot/control/drive_setpoint.h"
#include "core/robot/control/grant_book.h"
#include "core/robot/control/stop_control.h"
#include "core/robot/link_status.h"

namespace leitstand {

/// How the operator's hold on a robot is.
struct DriveView {
    bool drivable = false;      ///< it takes drive commands
    DriveVelocity velocity;     ///< as sent last
    bool focus = false;         ///< the sticks are this robot's
    bool driving = false;       ///< permitted, with fresh sticks
    bool needsNeutral = false;  ///< the sticks have to be let go first
    bool listening = false;     ///< the robot hears drive commands
};

/// One robot as the station has it now.
struct RobotView {
    LinkStatus link;
    GrantView grant;
    StopStatus stop;
    DriveView drive;
    std::optional<VirtualScanView> around;  ///< where it was asked for
};

}  // namespace leitstand
