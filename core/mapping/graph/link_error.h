#pragma once

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand {

using LinkVector = Eigen::Matrix<double, 6, 1>;

/// Returns how far two poses are from what @p link holds: e = (t, 2 vec q) of link^-1 * from^-1 * to [m,
/// rad]. The sign of q is the one whose scalar part is not negative.
[[nodiscard]] LinkVector linkError(const Pose& from, const Pose& to, const Pose& link);

/// linkError() and its derivatives by the poses, each moved by (t, r) to pose * (t, exp r).
struct LinearLink {
    LinkVector error;
    Eigen::Matrix<double, 6, 6> byFrom, byTo;
};
[[nodiscard]] LinearLink linearLink(const Pose& from, const Pose& to, const Pose& link);

/// Returns @p pose moved by (t, r) in its own frame: pose * (t, exp r).
[[nodiscard]] Pose movedBy(const Pose& pose, const LinkVector& step);

}  // namespace leitstand
