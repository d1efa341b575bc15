#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"

namespace leitstand {

/// The pose of a robot at one time.
struct PathPose {
    Time time{};
    Pose baseInMap = Pose::Identity();
    bool afterGap = false;  ///< whether the way from the previous pose is unknown
};

/// A known pose of a robot, with which its odometry is placed in the map.
struct PathAnchor {
    Time time{};                        ///< robot's clock
    Pose baseInMap = Pose::Identity();  ///< base_link at that time
};

/// The path of a robot through the map, oldest first.
struct RobotPath {
    std::string robot;
    std::vector<PathPose> poses;  ///< their times are on the station's clock

    /// Returns the length of the known parts of the path [m].
    [[nodiscard]] double length() const;
};

/// Returns the path of a robot from @p odometry (base_link in odom, robot's clock), placed in the map by
/// @p anchors. Both are sorted by time. The anchors before and after a pose place it, weighted by time.
/// Before the first anchor and after the last, only that anchor is used. Without odometry, the path consists
/// of the anchors. Anchors more than 1 s after the end of odometry are appended after a gap. isGap() decides
/// where else the way is unknown. A pose is left out if it is within @p apart [m] and 10 degrees of the last
/// pose that was kept.
[[nodiscard]] std::vector<PathPose> joinedPath(std::span<const PathAnchor> anchors,
                                               std::span<const PathPose> odometry, double apart = 0.02);

}  // namespace leitstand
