#pragma once

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand {

/// The expected error of odometry after a step: a constant, and a share of the step.
struct OdometryDrift {
    double share = 0.03;                ///< of the distance [m / m]
    double atLeast = 0.004;             ///< [m]
    double turnShare = 0.03;            ///< of the turn [rad / rad]
    double turnAtLeast = degrees(0.3);  ///< [rad]

    /// Returns standard deviations after @p way [m] and @p turn [rad]: translation [m], then rotation [rad],
    /// the same for all axes.
    [[nodiscard]] Eigen::Matrix<double, 6, 1> deviation(double way, double turn) const {
        Eigen::Matrix<double, 6, 1> deviation;
        deviation.head<3>().setConstant(atLeast + share * way);
        deviation.tail<3>().setConstant(turnAtLeast + turnShare * turn);
        return deviation;
    }
};

}  // namespace leitstand
