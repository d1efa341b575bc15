#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/mapping/live/trail.h"

namespace leitstand {

/// Where a robot is in the map now, a snapshot for views: its newest place in the map, continued by its
/// odometry.
struct RobotInMap {
    std::string robot;
    bool placed = false;                ///< whether it has a pose in the map; else the rest is not valid
    Pose baseInMap = Pose::Identity();  ///< base_link, level by the inertial unit
    Time stamp{};                       ///< of its newest odometry, robot's clock
    /// Pose of the odometry's frame in the map at `stamp`; empty where it is unknown.
    std::optional<Pose> odomInMap = {};
    /// When its newest 3D scan was registered to the map, station's clock. If another station makes the map,
    /// it is when the newest scan registered there was received here. Empty: none so far.
    std::optional<Time> matched = {};
    double certainty = 0.0;  ///< 0 to 1
    bool certain = false;    ///< its newest scan fits; else its odometry alone continues its pose
    std::string how;         ///< English text: how its pose was found, or why it is doubted
    TrailPtr trail = std::make_shared<const Trail>();  ///< about 10 cm from place to place; never null
    double spinning = 0.0;  ///< distance that its wheels turned while its scans show it at rest [m]
    bool afterGap = false;  ///< the path to baseInMap from the trail's end is unknown
};
/// All robots of the station by name, immutable.
using RobotsInMap = std::vector<RobotInMap>;
using RobotsInMapPtr = std::shared_ptr<const RobotsInMap>;

}  // namespace leitstand
