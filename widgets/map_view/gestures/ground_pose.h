#pragma once

#include <optional>

#include <Eigen/Core>

namespace leitstand {

/// A place on the floor, and the way to look there, as an operator draws it.
struct GroundPose {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< in the map's frame [m]
    std::optional<double> heading = {};  ///< from x to the left [rad]; empty: only clicked, none was drawn
};

/// A step of something that an operator drags over the floor.
struct GroundDrag {
    Eigen::Vector3d from = Eigen::Vector3d::Zero();  ///< where it was grabbed, in the map's frame [m]
    Eigen::Vector3d to = Eigen::Vector3d::Zero();    ///< where that is now [m]
    bool turns = false;                              ///< it is turned, not moved
    bool begins = false;                             ///< it was grabbed just now
};

}  // namespace leitstand
