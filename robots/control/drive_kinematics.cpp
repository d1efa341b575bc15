#include "robots/control/drive_kinematics.h"

#include <algorithm>
#include <cmath>

namespace leitstand {

SideSpeeds sidesFor(const DriveVelocity& velocity, const DriveGeometry& geometry) {
    if (!std::isfinite(velocity.forward) || !std::isfinite(velocity.turn)) return {};
    const double half = 0.5 * velocity.turn * geometry.trackWidth;
    SideSpeeds sides{velocity.forward - half, velocity.forward + half};
    const double fastest = std::max(std::abs(sides.left), std::abs(sides.right));
    if (!(geometry.maxSpeed > 0.0)) return {};
    if (fastest > geometry.maxSpeed) {
        sides.left *= geometry.maxSpeed / fastest;
        sides.right *= geometry.maxSpeed / fastest;
    }
    return sides;
}

DriveVelocity velocityOf(const SideSpeeds& sides, const DriveGeometry& geometry) {
    const double turn = geometry.trackWidth > 0.0 ? (sides.right - sides.left) / geometry.trackWidth : 0.0;
    return {0.5 * (sides.left + sides.right), 0.0, turn};
}

}  // namespace leitstand
