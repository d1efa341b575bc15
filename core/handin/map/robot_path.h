#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"

namespace leitstand {

/// Where a robot was at a moment.
struct PathPose {
    Time time{};
    Pose baseInMap = Pose::Identity();
    bool afterGap = false;  ///< nobody knows the way to it from the pose before
};

/// What tells where odometry's poses lie in the map.
struct PathAnchor {
    Time time{};                        ///< robot's clock
    Pose baseInMap = Pose::Identity();  ///< then
};

/// The way of a robot through the map, oldest first.
struct RobotPath {
    std::string robot;
    std::vector<PathPose> poses;  ///< station's clock

    /// Length of the way, as far as it is known [m].
    [[nodiscard]] double length() const;
};

/// The way that odometry tells between @p anchors: each of its poses is put where the anchors before and
/// after have the odometry then, weighted by time; before the first anchor and after the last that one alone
/// counts. Without odometry it is the anchors. Poses nearer than @p apart [m] (and 10 degrees) to the one
/// before are left out; anchors after the end of odometry follow, after a gap. isGap() tells where the
/// way is not known. Both are sorted by time; odometry: base_link in odom, robot's clock.
[[nodiscard]] std::vector<PathPose> joinedPath(std::span<const PathAnchor> anchors,
                                               std::span<const PathPose> odometry, double apart = 0.02);

}  // namespace leitstand
