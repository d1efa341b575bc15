#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/mapping/live/trail.h"

namespace leitstand {

/// Where a robot is in the map now, a snapshot for views: its newest place in the map, carried on by its
/// odometry.
struct RobotInMap {
    std::string robot;
    bool placed = false;  ///< whether the map's frame means anything to it: else no more is said
    Pose baseInMap = Pose::Identity();  ///< base_link, level by the inertial unit
    Time stamp{};                       ///< of its newest odometry, robot's clock
    /// Where its odometry's poses lie in the map: of the moment of baseInMap too; empty while nobody knows.
    std::optional<Pose> odomInMap = {};
    /// When a 3D scan of its own was laid onto the map last, station's clock; where another station makes the
    /// map, when one came in that is laid onto it there; empty: none was yet.
    std::optional<Time> matched = {};
    double certainty = 0.0;  ///< 0 to 1
    bool certain = false;    ///< its newest scan fits; else its odometry alone carries it on
    std::string how;         ///< it came there, or why that is doubted, in words, in English
    TrailPtr trail = std::make_shared<const Trail>();  ///< some 10 cm from place to place; never null
    double spinning = 0.0;  ///< way that its wheels turned while its scans say that it stands [m]
    bool afterGap = false;  ///< nobody knows the way to baseInMap from the trail's end
};
/// All robots of the station by name, immutable.
using RobotsInMap = std::vector<RobotInMap>;
using RobotsInMapPtr = std::shared_ptr<const RobotsInMap>;

}  // namespace leitstand
