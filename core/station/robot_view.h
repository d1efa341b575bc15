#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/perception/pictures/picture_watch.h"
#include "core/perception/surroundings/virtual_scan_view.h"
#include "core/robot/control/drive_setpoint.h"
#include "core/robot/control/grant_view.h"
#include "core/robot/control/stop/stop_status.h"
#include "core/robot/link/link_status.h"
#include "core/robot/link/reception.h"
#include "core/robot/services/goal_tracker.h"
#include "core/station/sight_cap.h"

namespace leitstand {

struct JointSample;

/// How the operator drives a robot now.
struct DriveView {
    bool drivable = false;      ///< whether it takes drive commands
    DriveVelocity velocity;     ///< velocity that was sent last
    bool focus = false;         ///< whether the sticks drive this robot
    bool driving = false;       ///< whether driving is permitted and the sticks are fresh
    bool needsNeutral = false;  ///< whether the sticks must be released first
    bool listening = false;     ///< whether the robot receives drive commands
    bool reachable = false;     ///< whether it would receive drive commands, even if none are sent now
    SightCap sight = {};        ///< how fast it may be driven, given what its driver sees, and why
};

/// The pictures of one camera as they arrive.
struct CameraView {
    std::string sensor;  ///< StreamDescription::sensor
    PictureAges age;
};

/// One robot as the station sees it now.
struct RobotView {
    LinkStatus link;
    std::optional<ReceptionFault> reception;  ///< announced, but not received properly; empty: no such fault
    GrantView grant;
    StopStatus stop;
    DriveView drive;
    NavigationView navigation;              ///< the robot's own navigation
    std::optional<VirtualScanView> around;  ///< virtual scan; empty: it was not requested
    std::vector<CameraView> cameras;        ///< cameras that sent pictures, except thermal ones
    /// Frames of scanners of which neither tf nor the robot's file tells the place; the base counts as it.
    std::vector<std::string> unplaced;
    std::shared_ptr<const JointSample> joints;  ///< newest joint states, including pan and tilt; null: none
    double jointsAge = std::numeric_limits<double>::infinity();  ///< age of `joints` [s]
};

}  // namespace leitstand
