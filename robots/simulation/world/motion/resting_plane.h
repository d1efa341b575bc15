#pragma once

#include <array>
#include <optional>
#include <span>

#include <Eigen/Core>

namespace leitstand::simulation {

/// A plane z = height + slope . (x, y) that rests on three points.
struct RestingPlane {
    double height = 0.0;                              ///< height at x = y = 0 [m]
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();  ///< slope along x and y
    std::array<int, 3> feet = {0, 1, 2};              ///< indices of the supporting points
    std::array<double, 3> shares = {};                ///< share of the weight on each; their sum is 1

    [[nodiscard]] double at(const Eigen::Vector2d& place) const { return height + slope.dot(place); }
};

/// Returns the plane on which a rigid body rests on @p points: the lowest plane below @p weight that has no
/// point above it. @p weight: x and y of the centre of mass. It is the facet of the upper convex hull at the
/// weight. Empty when the weight is outside the points' hull, so that the body falls over. @p guess: feet to
/// start from, such as those of the last call.
[[nodiscard]] std::optional<RestingPlane> restingPlane(std::span<const Eigen::Vector3d> points,
                                                       const Eigen::Vector2d& weight,
                                                       const std::array<int, 3>& guess = {0, 1, 2});

}  // namespace leitstand::simulation
