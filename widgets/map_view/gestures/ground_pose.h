#pragma once

#include <optional>

#include <Eigen/Core>

namespace leitstand {

/// A place on the floor and a heading, as an operator draws them.
struct GroundPose {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< in the map's frame [m]
    std::optional<double> heading = {};  ///< counter-clockwise from x [rad]; empty: the operator did not drag
};

/// One step of dragging something over the floor.
struct GroundDrag {
    Eigen::Vector3d from = Eigen::Vector3d::Zero();  ///< where it was grabbed, in the map's frame [m]
    Eigen::Vector3d to = Eigen::Vector3d::Zero();    ///< where that point is now, in the map's frame [m]
    bool turns = false;                              ///< the thing is turned, not moved
    bool begins = false;                             ///< first step of a drag
};

}  // namespace leitstand
