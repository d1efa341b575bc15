#pragma once

#include <optional>

#include <Eigen/Core>

namespace leitstand {

/// A place on the floor, and the way to look there, as an operator draws it.
struct GroundPose {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< in the map's frame [m]
    std::optional<double> heading = {};  ///< from x to the left [rad]; empty: only clicked, none was drawn
};

}  // namespace leitstand
