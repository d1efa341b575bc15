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

/// A pose as it was estimated (in the map) and as it truly was (in the world).
struct PosePair {
    Pose estimated = Pose::Identity(), truth = Pose::Identity();
};

/// How far a trajectory is from the truth (absolute trajectory error, Sturm et al. 2012).
struct TrajectoryError {
    int poses = 0;
    double position = 0.0;               ///< root mean square [m]
    double rotation = 0.0;               ///< root mean square [rad]
    Pose mapInWorld = Pose::Identity();  ///< where the map fits the truth best: turned about z and shifted
};

/// Returns those of @p estimated whose moment @p truth covers, with the interpolated true pose. It covers a
/// moment with a pose within a quarter of a second before, and one after. Both are sorted by time.
[[nodiscard]] std::vector<PosePair> pairsOf(std::span<const StampedPose> estimated,
                                            std::span<const StampedPose> truth);

/// Returns the error of @p pairs after the map, level like the world, was turned about z and shifted to fit
/// best. The fit is least squares over positions and points half a metre ahead of them. So a robot that stood
/// or drove straight ahead also has a heading. Empty without pairs.
[[nodiscard]] std::optional<TrajectoryError> trajectoryError(std::span<const PosePair> pairs);

}  // namespace leitstand
