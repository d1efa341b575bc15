#pragma once

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand {

using LinkVector = Eigen::Matrix<double, 6, 1>;

/// Returns by how much the relative pose of @p from and @p to differs from @p link. With link^-1 * from^-1 *
/// to = (t, q), that is e = (t, 2 vec q) [m, rad]. q is the unit quaternion whose scalar part is not
/// negative.
[[nodiscard]] LinkVector linkError(const Pose& from, const Pose& to, const Pose& link);

/// linkError() and its Jacobians: for a step (t, r) of `from`, and for one of `to`, as in movedBy().
struct LinearLink {
    LinkVector error;
    Eigen::Matrix<double, 6, 6> byFrom, byTo;
};
[[nodiscard]] LinearLink linearLink(const Pose& from, const Pose& to, const Pose& link);

/// Returns @p pose moved by @p step = (t, r) [m, rad] in its own frame: pose * (t, exp r).
[[nodiscard]] Pose movedBy(const Pose& pose, const LinkVector& step);

}  // namespace leitstand
