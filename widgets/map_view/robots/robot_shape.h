#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace leitstand {

struct RobotMark;

/// The part of a robot that a facet belongs to.
enum class RobotPart : std::uint8_t { Gear, Body, Mast, Arrow };

/// A flat part of a robot's surface.
struct RobotFacet {
    std::vector<Eigen::Vector3d> corners;  ///< in base_link, counter-clockwise seen from outside [m]
    Eigen::Vector3d outward = Eigen::Vector3d::UnitZ();
    RobotPart part = RobotPart::Body;
    double light = 1.0;  ///< brightness, as a share of the part's colour
};

/// Returns the facets of a robot as an easily recognised symbol. It has a low body as large as the robot's
/// footprint, wheels or chains, a mast of the robot's height, and an arrow on top that points ahead.
[[nodiscard]] std::vector<RobotFacet> robotFacets(const RobotMark& robot);

}  // namespace leitstand
