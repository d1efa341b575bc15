#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace leitstand {

/// Area of a polygon [m^2]; positive when its corners are counter-clockwise.
[[nodiscard]] double signedArea(const std::vector<Eigen::Vector2d>& corners);

/// Returns why @p corners are no valid outline of a robot, "expected ..., found ..."; empty when they are
/// valid. An outline has three to 64 corners and an area. Its sides touch each other only at their common
/// corners.
[[nodiscard]] std::string footprintProblem(const std::vector<Eigen::Vector2d>& corners);

}  // namespace leitstand
