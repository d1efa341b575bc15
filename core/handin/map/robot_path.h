#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"

namespace leitstand {

/// The pose of a robot at a moment.
struct PathPose {
    Time time{};
    Pose baseInMap = Pose::Identity();
    bool afterGap = false;  ///< the way from the pose before is unknown
};

/// A known pose of a robot, which places its odometry in the map.
struct PathAnchor {
    Time time{};                        ///< robot's clock
    Pose baseInMap = Pose::Identity();  ///< at that time
};

/// The path of a robot through the map, oldest first.
struct RobotPath {
    std::string robot;
    std::vector<PathPose> poses;  ///< station's clock

    /// Returns the length of the path, as far as it is known [m].
    [[nodiscard]] double length() const;
};

/// Returns the path by odometry between @p anchors. The anchors before and after each pose place it, weighted
/// by time. Before the first anchor and after the last, that one alone counts. Without odometry the path is
/// the anchors. Poses nearer than @p apart [m] (and 10 degrees) to the previous one are left out. Anchors
/// after the end of odometry follow, after a gap. isGap() decides where the way is unknown. Both are sorted
/// by time; odometry: base_link in odom, robot's clock.
[[nodiscard]] std::vector<PathPose> joinedPath(std::span<const PathAnchor> anchors,
                                               std::span<const PathPose> odometry, double apart = 0.02);

}  // namespace leitstand
