#include "core/robot/goal.h"

#include <cmath>

namespace leitstand {
namespace {

/// Position and heading of @p pose.
Pose levelled(const Pose& pose) {
    const Eigen::Vector3d ahead = pose.linear().col(0);
    return poseFrom(pose.translation(), 0, 0, std::atan2(ahead.y(), ahead.x()));
}

}  // namespace

Pose goalInOdom(const Pose& baseInMap, const Pose& baseInOdom, const Pose& goalInMap) {
    return levelled(baseInOdom) * levelled(baseInMap).inverse() * levelled(goalInMap);
}

}  // namespace leitstand
