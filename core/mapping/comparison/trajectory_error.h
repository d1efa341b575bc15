#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"

namespace leitstand {

/// Where something was at a moment.
struct StampedPose {
    Time at{};
    Pose pose = Pose::Identity();
};

/// A pose as it was estimated (in the map), and the true pose at the same time (in the world).
struct PosePair {
    Pose estimated = Pose::Identity(), truth = Pose::Identity();
};

/// How far a trajectory is from the truth (absolute trajectory error, Sturm et al. 2012).
struct TrajectoryError {
    int poses = 0;
    double position = 0.0;  ///< root mean square [m]
    double rotation = 0.0;  ///< root mean square [rad]
    /// Pose at which the map fits the truth best; it is only turned about z and shifted.
    Pose mapInWorld = Pose::Identity();
};

/// Pairs poses of @p estimated with the true poses at the same times, interpolated from @p truth. A pose is
/// left out when @p truth has no pose at its time, and none within 0.25 s before or after. Both arguments are
/// sorted by time.
[[nodiscard]] std::vector<PosePair> pairsOf(std::span<const StampedPose> estimated,
                                            std::span<const StampedPose> truth);

/// Returns the error of @p pairs after the map was turned about z and shifted to fit the truth best; both are
/// level. The fit is least squares over the positions, and over points half a metre ahead of them. These
/// points determine a heading even if the robot stood or drove straight ahead. Empty: no pairs.
[[nodiscard]] std::optional<TrajectoryError> trajectoryError(std::span<const PosePair> pairs);

}  // namespace leitstand
