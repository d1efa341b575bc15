#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand {

/// How large a robot is, and where its sensors sit.
struct RobotMeasures {
    std::vector<Eigen::Vector2d> footprint;     ///< in the base frame [m]
    double height = 0.0;                        ///< [m]
    std::map<std::string, Pose> sensorsInBase;  ///< by their names in the file; others stay as they are
};

}  // namespace leitstand
