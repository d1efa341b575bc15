#pragma once

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand {

using LinkVector = Eigen::Matrix<double, 6, 1>;

/// How far two poses are from what a link says of them: e = (t, 2 vec q) of link^-1 * from^-1 * to, with q of
/// its two signs the one whose scalar part is not negative [m, rad].
[[nodiscard]] LinkVector linkError(const Pose& from, const Pose& to, const Pose& link);

/// linkError() and how it changes when the poses do: each is moved by (t, r) to pose * (t, exp r).
struct LinearLink {
    LinkVector error;
    Eigen::Matrix<double, 6, 6> byFrom, byTo;
};
[[nodiscard]] LinearLink linearLink(const Pose& from, const Pose& to, const Pose& link);

/// @p pose moved by (t, r), in its own frame: pose * (t, exp r).
[[nodiscard]] Pose movedBy(const Pose& pose, const LinkVector& step);

}  // namespace leitstand
