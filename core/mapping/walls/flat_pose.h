#pragma once

#include <Eigen/Geometry>

#include "core/base/pose.h"
#include "core/base/rotation/heading.h"

namespace leitstand {

/// A place and a heading on a plane.
struct FlatPose {
    Eigen::Vector2d place = Eigen::Vector2d::Zero();  ///< [m]
    double heading = 0.0;                             ///< [rad]

    [[nodiscard]] static FlatPose of(const Pose& pose) {
        return {pose.translation().head<2>(), headingOf(pose)};
    }
    /// Returns this pose in space, level and at @p height [m].
    [[nodiscard]] Pose standing(double height) const {
        return poseFrom({place.x(), place.y(), height}, 0.0, 0.0, heading);
    }
    [[nodiscard]] Eigen::Vector2d operator*(const Eigen::Vector2d& point) const {
        return place + Eigen::Rotation2Dd(heading) * point;
    }
};

}  // namespace leitstand
