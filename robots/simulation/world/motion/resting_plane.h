#pragma once

#include <array>
#include <optional>
#include <span>

#include <Eigen/Core>

namespace leitstand::simulation {

/// A plane z = height + slope . (x, y) that rests on three points.
struct RestingPlane {
    double height = 0.0;                              ///< at x = y = 0 [m]
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();  ///< along x and y
    std::array<int, 3> feet = {0, 1, 2};              ///< indices of the points that carry
    std::array<double, 3> shares = {};                ///< of the weight on each; sum 1

    [[nodiscard]] double at(const Eigen::Vector2d& place) const { return height + slope.dot(place); }
};

/// Returns the plane on which a stiff body rests on @p points: the lowest one under @p weight (x, y of its
/// centre of mass) with no point above it. It is the facet of the upper convex hull over the weight. Empty
/// when the weight is not above the points' hull and the body falls over. @p guess: feet to start from, those
/// of the last call.
[[nodiscard]] std::optional<RestingPlane> restingPlane(std::span<const Eigen::Vector3d> points,
                                                       const Eigen::Vector2d& weight,
                                                       const std::array<int, 3>& guess = {0, 1, 2});

}  // namespace leitstand::simulation
