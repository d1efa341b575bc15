#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace leitstand {

/// Area of a polygon [m^2], positive when its corners go counter-clockwise.
[[nodiscard]] double signedArea(const std::vector<Eigen::Vector2d>& corners);

/// Returns why @p corners are not an outline of a robot, "expected ..., found ..."; empty when they are. An
/// outline has three to 64 corners and an area, and none of its sides touches another except at their common
/// corner.
[[nodiscard]] std::string footprintProblem(const std::vector<Eigen::Vector2d>& corners);

}  // namespace leitstand
