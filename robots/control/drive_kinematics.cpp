#include "robots/control/drive_kinematics.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace leitstand {

SideSpeeds sidesFor(const DriveVelocity& velocity, const DriveGeometry& geometry) {
    if (!std::isfinite(velocity.forward) || !std::isfinite(velocity.turn)) return {};
    const auto [left, right] = tracksOf(velocity, geometry.trackWidth);
    SideSpeeds sides{left, right};
    const double fastest = std::max(std::abs(sides.left), std::abs(sides.right));
    if (!(geometry.maxSpeed > 0.0)) return {};
    if (fastest > geometry.maxSpeed) {
        sides.left *= geometry.maxSpeed / fastest;
        sides.right *= geometry.maxSpeed / fastest;
    }
    return sides;
}

DriveVelocity velocityOf(const SideSpeeds& sides, const DriveGeometry& geometry) {
    return velocityOf(std::pair(sides.left, sides.right), geometry.trackWidth);
}

}  // namespace leitstand
