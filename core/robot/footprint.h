#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace leitstand {

/// Area of a polygon [m^2], positive when its corners go counter-clockwise.
[[nodiscard]] double signedArea(const std::vector<Eigen::Vector2d>& corners);

/// Why @p corners are no outline of a robot, "expected ..., found ..."; empty when they are one: three to 64
/// corners, no side that touches another, an area.
[[nodiscard]] std::string footprintProblem(const std::vector<Eigen::Vector2d>& corners);

}  // namespace leitstand
