#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/mapping/comparison/trajectory_error.h"

namespace leitstand {

class BagReader;

/// What a mission holds of the truth, where somebody recorded it beside what the robots said.
struct RecordedTruth {
    std::map<std::string, std::vector<StampedPose>> robots;  ///< base_link in the world, by name, by time
    std::vector<Eigen::Vector3d> victims;                    ///< in the world [m]
};

/// Reads `/truth/ARENA/...` of simulated robots (docs/simulation.md): odometry of kinds of robots, told apart
/// by its child frame, and victims; and `/NAME/ground_truth` (nav_msgs/Odometry) of others. What makes no
/// sense is left out. Cancelled: what was read so far.
[[nodiscard]] RecordedTruth readTruth(BagReader& bag, const Progress& progress = {});

}  // namespace leitstand
