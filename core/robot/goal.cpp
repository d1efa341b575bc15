#include "core/robot/goal.h"

#include "core/base/rotation/heading.h"

namespace leitstand {
namespace {

/// @p pose reduced to position and heading.
Pose levelled(const Pose& pose) {
    return poseFrom(pose.translation(), 0, 0, headingOf(pose));
}

}  // namespace

Pose goalInOdom(const Pose& baseInMap, const Pose& baseInOdom, const Pose& goalInMap) {
    return levelled(baseInOdom) * levelled(baseInMap).inverse() * levelled(goalInMap);
}

GoalMove goalMove(const Pose& goalInMap, const Pose& correction, bool underWay) {
    constexpr double Noticed = 0.01, Most = 1.0;  // [m]
    const Pose moved = correction * goalInMap;
    const double shift = distanceBetween(goalInMap, moved);
    if (shift < Noticed && angleBetween(goalInMap, moved) < degrees(1)) return GoalMove::Stays;
    return underWay && shift < Most ? GoalMove::Moves : GoalMove::Withdrawn;
}

}  // namespace leitstand
