#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace leitstand {

struct RobotMark;

/// What a facet of a robot is part of.
enum class RobotPart : std::uint8_t { Gear, Body, Mast, Arrow };

/// A flat piece of a robot's outside.
struct RobotFacet {
    std::vector<Eigen::Vector3d> corners;  ///< base_link, counter-clockwise from outside [m]
    Eigen::Vector3d outward = Eigen::Vector3d::UnitZ();
    RobotPart part = RobotPart::Body;
    double light = 1.0;  ///< share of the part's colour
};

/// A robot as a sign that is told from others: a low body as large as its footprint, wheels or chains beside
/// it, a mast up to its height, and an arrow on top that points ahead.
[[nodiscard]] std::vector<RobotFacet> robotFacets(const RobotMark& robot);

}  // namespace leitstand
