#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/mapping/comparison/trajectory_error.h"

namespace leitstand {

class BagReader;

/// Ground truth that was recorded in a mission in addition to the robots' own data.
struct RecordedTruth {
    std::map<std::string, std::vector<StampedPose>>
        robots;                            ///< base_link in the world by robot's name, in order of time
    std::vector<Eigen::Vector3d> victims;  ///< positions in the world [m]
};

/// Reads the topics `/truth/ARENA/...` of simulated robots (docs/simulation.md): the victims, and an odometry
/// topic for each kind of robot, whose child frame names the robot. For other robots, reads
/// `/NAME/ground_truth` (nav_msgs/Odometry). Leaves out samples that are invalid or name no robot. When
/// cancelled, returns what was read so far.
[[nodiscard]] RecordedTruth readTruth(BagReader& bag, const Progress& progress = {});

}  // namespace leitstand
