#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "robots/simulation/arena/mesh.h"

namespace leitstand::simulation {

Pose MovingPart::at(double seconds) const {
    const double phase = period > 0.0 ? std::sin(2.0 * std::numbers::pi * seconds / period) : 0.0;
    return Eigen::Translation3d(phase * sway) * hinge * Eigen::AngleAxisd(phase * swing, axis.normalized());
}

}  // namespace leitstand::simulation
