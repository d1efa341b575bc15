#pragma once

#include <vector>

#include "core/base/pose.h"

namespace leitstand::simulation::test {

/// Poses that were found of scans, and the true ones.
struct Trajectory {
    std::vector<Pose> found;  ///< base_link in the map
    std::vector<Pose> truth;  ///< base_link in the arena
};

/// How far a trajectory is from the truth, after the rigid motion that brings it nearest to it (Horn 1987).
struct TrajectoryError {
    double distance = 0.0;               ///< root mean square [m]
    double angle = 0.0;                  ///< likewise [rad]
    double height = 0.0;                 ///< of the distance, along z [m]
    double tilt = 0.0;                   ///< of the angle, about level axes, without the alignment [rad]
    Pose mapInArena = Pose::Identity();  ///< the alignment
};
[[nodiscard]] TrajectoryError errorOf(const Trajectory& trajectory);

/// Where the way meets itself: of all pairs of scans that are truly within 1.5 m of each other and more than
/// 10 m apart along the way, the largest error of their relative position [m]; 0 where it nowhere does.
[[nodiscard]] double worstSeam(const Trajectory& trajectory);

}  // namespace leitstand::simulation::test
