#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/mapping/live/trail.h"

namespace leitstand {

/// A snapshot of where a robot is in the map now, for views: its newest known place, continued by its
/// odometry.
struct RobotInMap {
    std::string robot;
    bool placed = false;                ///< whether it has a pose in the map; otherwise the rest is not valid
    Pose baseInMap = Pose::Identity();  ///< base_link, levelled by the inertial unit
    Time stamp{};                       ///< stamp of its newest odometry, robot's clock
    /// Pose of the odometry's frame in the map at `stamp`; empty: unknown.
    std::optional<Pose> odomInMap = {};
    /// When its newest 3D scan was registered in the map, station's clock. If another station makes the map:
    /// when this station received the newest scan registered there. Empty: none so far.
    std::optional<Time> matched = {};
    double certainty = 0.0;  ///< certainty of the pose, 0 to 1
    bool certain = false;    ///< whether its newest scan fits; if not, only odometry continues its pose
    std::string how;         ///< English text: how its pose was found, or why it is in doubt
    TrailPtr trail = std::make_shared<const Trail>();  ///< places about 10 cm apart; never null
    double spinning = 0.0;  ///< distance that its wheels turned while its scans show that it stands [m]
    bool afterGap = false;  ///< whether the path from the end of the trail to baseInMap is unknown
};
/// All robots of the station by name, immutable.
using RobotsInMap = std::vector<RobotInMap>;
using RobotsInMapPtr = std::shared_ptr<const RobotsInMap>;

}  // namespace leitstand
