#pragma once

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand {

/// The expected error of odometry after a step: a constant plus a share of the step.
struct OdometryDrift {
    double share = 0.03;                ///< error of the distance per distance [m / m]
    double atLeast = 0.004;             ///< constant error of the distance [m]
    double turnShare = 0.03;            ///< error of the turn per turn [rad / rad]
    double turnAtLeast = degrees(0.3);  ///< constant error of the turn [rad]

    /// Returns standard deviations after driving @p way [m] and turning @p turn [rad]. The translation [m]
    /// comes first, then the rotation [rad]; all axes have the same values.
    [[nodiscard]] Eigen::Matrix<double, 6, 1> deviation(double way, double turn) const {
        Eigen::Matrix<double, 6, 1> deviation;
        deviation.head<3>().setConstant(atLeast + share * way);
        deviation.tail<3>().setConstant(turnAtLeast + turnShare * turn);
        return deviation;
    }
};

}  // namespace leitstand
